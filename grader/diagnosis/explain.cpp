#include "diagnosis/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/bounds.h"
#include "diagnosis/by_textbook.h"
#include "diagnosis/calls_made.h"
#include "diagnosis/own_numbers.h"
#include "diagnosis/right_otherwise.h"
#include "diagnosis/rule.h"
#include "diagnosis/shares.h"
#include "diagnosis/simplest.h"
#include "diagnosis/spread.h"
#include "diagnosis/surest.h"
#include "diagnosis/terms.h"
#include "diagnosis/where.h"
#include "diagnosis/where_in_textbook.h"

namespace grade {

namespace {

/// The calls, of which only those parts are told that an answer to a wrong call depends on.
Calls with_parts_that_matter(Calls calls, const Ask& mine, const Ask& right) {
    const Calls wrong = only_wrong(calls);
    if (wrong.size() == 0) return calls;
    const auto depends = dependences(wrong, calls, mine, right);
    for (std::size_t i = 0; i < depends.size(); ++i)
        calls.told[i] = calls.told[i] && (depends[i].mine > 0 || depends[i].right > 0);
    return calls;
}

/// The call of a finding, in words, and as it can be pasted into a program and into a shell.
void add_call(Finding& finding, const Signature& signature, const Example& example) {
    finding.arguments = arguments_in_words(signature, example.row, {example.told, example.always, example.digits});
    finding.code = call_in_code(signature, example.row);
    if (are_readable(signature))
        finding.command = fmt::format("./grade call {} '{}'", signature.fragment, finding.arguments);
}

/// The calls, of which only those count as wrong whose answer is no number.
Calls only_nan(Calls calls) {
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (!is_nan(calls.mine[k], calls.right[k])) calls.mine[k] = calls.right[k];
    return calls;
}

std::string which(const WrongCalls& region) { return (region.is_exact ? "those " : "") + region.words; }

/// What sets wrong calls apart, in arguments or in variables of a form; in these rather than in the right answers.
WrongCalls region_of(const Calls& calls, bool is_known) {
    WrongCalls region = where_wrong(calls);
    return is_known || (region.is_exact && !region.of_answers) ? region : where_wrong_in_textbook(calls, region);
}

/// What code takes for granted that is wrong only where it does not hold.
std::string assumption(const WrongCalls& region) {
    if (!region.is_exact || region.not_unit.empty()) return {};
    return fmt::format("the length of `{}` is taken to be 1: it may have any", region.not_unit);
}

/// Which calls are wrong, or which are no number.
WrongCalls tell_where(Finding& finding, const Calls& all, std::size_t wrong, std::size_t not_numbers, bool is_known) {
    if (not_numbers > 0)
        if (WrongCalls region = region_of(only_nan(all), false); !region.words.empty()) {
            finding.where = fmt::format("{} of {} calls are nan, {}", not_numbers, all.size(), which(region));
            return region;
        }
    if (wrong == all.size()) return {};
    WrongCalls region = region_of(all, is_known);
    finding.where = fmt::format("{} of {} calls are wrong", wrong, all.size());
    if (not_numbers > 0) finding.where += fmt::format(", {} of them nan", not_numbers);
    if (!region.words.empty()) finding.where += ", " + which(region);
    return region;
}

/// What is wrong with samples that are not the solution's call by call: what no right one does, or how they are spread.
Finding of_samples(Finding finding, const Calls& all, const std::optional<Broken>& broken, const Ask& ask_mine,
                   const Ask& ask_right) {
    std::size_t left = most_calls;
    if (broken) {
        const std::size_t k = broken->call;
        const Example example = as_printed(all, {all.rows[k], all.mine[k], all.right[k], 6, all.told},
                                           limited(ask_mine, left), limited(ask_right, left));
        finding.answer = result_in_words(all.signature, example.mine);
        add_call(finding, all.signature, example);
        Calls known = all;  // others may be right
        for (std::size_t i = 0; i < all.size(); ++i)
            if (std::ranges::count(broken->calls, i) == 0) known.mine[i] = known.right[i];
        tell_where(finding, known, broken->calls.size(), 0, true);
        return finding;
    }
    if (finding.how.empty())
        finding.how = spread_of(all, all, limited(ask_mine, left), limited(ask_right, left)).value_or("");
    return finding;
}

/// What is wrong with a sample beside its place.
std::string of_own_numbers(const Calls& all, const Ask& mine, const Ask& right) {
    const auto own = with_own_numbers(all, right);
    if (!own) return {};
    const auto differs = [&](std::size_t k) { return !is_equal(own->result, own->mine[k], own->right[k]); };
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < own->size(); ++k) wrong += differs(k);
    bool right_otherwise = false;
    auto found = wrong > 0 ? relation_of(*own, right, false, right_otherwise) : std::nullopt;
    std::size_t left = most_of_textbook;
    if (wrong > 0) found = simpler(found, relation_of_textbook(*own, false, right_otherwise, left));
    if (is_exact(found)) return found->words + found->usually;
    if (wrong > 0) return {};
    const auto place = std::ranges::find_if(own->result.parts, is_place),
               measure = std::ranges::find_if_not(own->result.parts, is_place);
    const auto spread = spread_of(all, all, mine, right);
    if (!spread || measure == own->result.parts.end()) return {};
    return fmt::format("each `{}` is right for its `{}`, but these are not spread so: {}", measure->name, place->name,
                       *spread);
}

/// Which values of a sum, or which of its shares, are wrong.
std::string wrong_sums(const Calls& all, const Ask& mine, const Ask& right) {
    const std::string rule = wrong_rule(all, mine, right);
    return rule.empty() ? wrong_shares(all, mine, right) : rule;
}

/// What is wrong where the answer is a number.
std::string of_numbers(const Calls& calls, const Ask& right, bool sampled) {
    const Calls some = those_of(calls, [&](std::size_t k) { return !is_nan(calls.mine[k], calls.right[k]); });
    bool right_otherwise = false;
    auto found = some.size() > 0 ? relation_of(some, right, sampled, right_otherwise) : std::nullopt;
    std::size_t left = most_of_textbook;
    if (some.size() > 0) found = simpler(found, relation_of_textbook(some, sampled, right_otherwise, left));
    if (some.size() > 0 && !is_exact(found)) found = two_of_textbook(some, left);
    const std::string words = "some answers are nan where the right one is a number";
    if (!is_exact(found)) return words;
    return fmt::format("{}; where it is a number, {}", words, found->words + found->usually);
}

/// The simplest wrong call. Of a sample there may be more than one right place, unless it is told what is done
/// otherwise.
void add_example(Finding& finding, const Calls& all, const WrongCalls& region, bool is_one_right, const Ask& ask_mine,
                 const Ask& ask_right) {
    std::size_t left = 4000;
    const Ask mine = limited(ask_mine, left), right = limited(ask_right, left);
    const Example simplest = simplest_wrong(all, region, mine, right);
    std::vector<bool> wrong_parts;
    bool is_place_wrong = false;
    for (const Field& part : all.result.parts) {
        wrong_parts.push_back(counts(all.result, part, simplest.mine, simplest.right) &&
                              !is_equal(part, simplest.mine, simplest.right));
        is_place_wrong = is_place_wrong || (wrong_parts.back() && is_place(part));
    }
    finding.answer = result_in_words(all.signature, simplest.mine, wrong_parts);
    if (is_one_right || !is_place_wrong) finding.right = result_in_words(all.signature, simplest.right, wrong_parts);
    add_call(finding, all.signature, simplest);
}

/// Whether all answers are nearly right.
bool are_near(const Calls& all) {
    constexpr double nearly = 1e-3;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (!is_alike(all.result, all.mine[k], all.right[k], nearly)) return false;
    return true;
}

/// Where in the fragment's own source the mistake is, and where no relation says all, what it is.
///
/// known  what else is known then
void add_repair(std::optional<Relation>& relation, const Calls& calls, const std::optional<Editable>& source,
                const std::string& known) {
    // that the answer is always the same says nothing of a cause
    const bool is_cause = is_exact(relation) && relation->words.find(always) == std::string::npos;
    const auto repair = source ? repair_of(calls, *source, is_cause) : std::nullopt;
    if (!repair) return;
    const bool is_all = repair->share == 1;
    if (is_exact(relation)) {
        if (!is_all && is_cause) return;
        relation->by_repair = is_all;
        const char* const see = relation->words.ends_with('?') ? " See" : ": see";
        constexpr double simple = 1.9;  // a change of arguments that a student may have made
        const bool is_told = relation->by_textbook || relation->cost < simple;
        relation->words += relation->words.starts_with(as_changed) && is_told
                               ? fmt::format("{} line {}", see, repair->line)
                               : "; " + repair->words;
    } else if (is_all || !relation || relation->explains == Relation::Explains::nothing ||
               relation->share < repair->share) {
        relation = Relation{known.empty() ? repair->words : known + "; " + repair->words};
        relation->by_repair = is_all, relation->share = repair->share;
        relation->explains = is_all ? Relation::Explains::all : Relation::Explains::some;
    }
}

}  // namespace

Finding explain(const Signature& signature, const Rows& rows, const Ask& ask, const Ask& ask_right,
                const std::function<std::optional<Editable>()>& source) try {
    std::size_t left = most_calls;
    const Ask ask_mine = without_right_ones(signature, rows, ask, ask_right);
    const Ask mine = limited(ask_mine, left), right = limited(ask_right, left);
    Calls all = compared(signature, rows, mine, right);
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < all.size(); ++k) wrong += !is_equal(all.result, all.mine[k], all.right[k]);
    Finding finding;
    if (are_near(all)) finding.how = small_offsets(all);
    if (wrong == 0) return finding;
    const auto depends = dependences(all, all, mine, right);
    for (const Dependence& d : depends) all.told.push_back(d.mine > 0 || d.right > 0);

    const auto& arguments = signature.arguments;
    const bool sampled = std::ranges::any_of(arguments, [](const auto& argument) { return argument.name == "u"; });
    bool right_otherwise = false;
    const Calls many_calls = crossed(all, mine, right);
    auto relation = surest_relation(many_calls, ask_mine, ask_right, sampled, right_otherwise);
    if (right_otherwise) return {};
    if (source) {
        const std::string unused = sampled ? unused_numbers(all, depends) : "";
        add_repair(relation, many_calls, source(), unused.empty() ? independence(all, depends) : unused);
    }
    finding.sampled = sampled;
    const bool is_known = is_exact(relation);
    if (is_known) {
        finding.by_arguments = relation->by_arguments, finding.by_textbook = relation->by_textbook;
        finding.by_repair = relation->by_repair;
    }
    const bool is_nothing = !relation || relation->explains == Relation::Explains::nothing;
    const auto broken = is_nothing ? broken_bound(all, right) : std::nullopt;
    std::size_t not_numbers = 0;
    for (std::size_t k = 0; k < all.size(); ++k) not_numbers += is_nan(all.mine[k], all.right[k]);
    constexpr double most = 0.9;
    const bool is_mostly_known = is_known || (relation && !is_nothing && relation->share >= most);
    // of a sample, that numbers are not used says more than how it is spread
    if (finding.how.empty() && sampled && not_numbers == 0 && !is_mostly_known && !broken)
        finding.how = unused_numbers(all, depends);
    if (finding.how.empty() && (not_numbers > 0 ? !is_known : !is_mostly_known))
        finding.how = not_numbers > 0 ? of_numbers(picked(many_calls, most_compared), right, sampled)
                      : !sampled      ? wrong_sums(all, mine, right)
                      : broken        ? ""
                                      : of_own_numbers(all, mine, right);
    if (finding.how.empty())
        finding.how = broken ? broken->words : is_nothing ? independence(all, depends) : relation->words;
    if (finding.how.empty() && relation) finding.how = relation->words;
    if (finding.how.empty()) finding.how = wrong_answers(all);
    // Another parametrisation is wrong in no call. Where many answers are the solution's, the random numbers are used
    // as the solution does, but perhaps not in calls of one kind.
    constexpr double many = 0.2;
    const bool is_comparable = !sampled || not_numbers > 0 || double(all.size() - wrong) >= many * double(all.size());
    if (sampled && (broken ? not_numbers == 0 : !is_comparable && !relation))
        return of_samples(finding, all, broken, ask_mine, ask_right);
    if (sampled && finding.how.empty()) finding.how = spread_of(only_wrong(all), all, mine, right).value_or("");

    const WrongCalls region =
        is_comparable ? tell_where(finding, with_parts_that_matter(all, mine, right), wrong, not_numbers, is_known)
                      : WrongCalls{};
    if (const std::string words = assumption(region); !words.empty() && !is_known) finding.how = words;
    const bool is_everywhere = relation && !is_nothing && (is_known || relation->everywhere);
    add_example(finding, all, region, !sampled || is_everywhere || not_numbers > 0, ask_mine, ask_right);
    return finding;
} catch (const std::out_of_range&) {
    return {};  // an answer that is too short
}

}  // namespace grade
