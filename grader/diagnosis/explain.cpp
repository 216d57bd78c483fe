#include "diagnosis/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/bounds.h"
#include "diagnosis/by_steps.h"
#include "diagnosis/own_numbers.h"
#include "diagnosis/relation.h"
#include "diagnosis/shares.h"
#include "diagnosis/simplest.h"
#include "diagnosis/spread.h"
#include "diagnosis/terms.h"
#include "diagnosis/where.h"

namespace grade {

namespace {

constexpr std::size_t most_compared = 80;    // calls among which a relation is looked for
constexpr std::size_t most_calls = 250'000;  // that the solution is asked for

/// The answers to as many rows as are asked for; where any is missing, none.
Ask limited(const Ask& ask, std::size_t& left) {
    return [&ask, &left](const Rows& rows) -> Rows {
        if (rows.size() > left) return {};
        left -= rows.size();
        Rows answers = ask(rows);
        return answers.size() == rows.size() ? answers : Rows{};
    };
}

/// Calls of which `most` are picked evenly, as many wrong as right ones where there are; others in between.
Calls picked(const Calls& all, std::size_t most, bool others = false) {
    std::vector<std::size_t> wrong, good;
    for (std::size_t k = 0; k < all.size(); ++k)
        (is_equal(all.result, all.mine[k], all.right[k]) ? good : wrong).push_back(k);
    const auto thin = [others](std::vector<std::size_t> from, std::size_t count) {
        if (from.size() <= count) return from;
        std::vector<std::size_t> some;
        for (std::size_t i = 0; i < count; ++i) some.push_back(from[(2 * i + others) * from.size() / (2 * count)]);
        return some;
    };
    const std::size_t of_right = std::min(good.size(), most - std::min(wrong.size(), most * 2 / 3));
    std::vector<std::size_t> chosen = thin(wrong, most - of_right);
    for (const std::size_t k : thin(good, of_right)) chosen.push_back(k);
    return those_of(all, [&](std::size_t k) { return std::ranges::count(chosen, k) > 0; });
}

/// In what share of the calls an answer changes with a part.
struct Dependence {
    double mine = 0, right = 0;
};

/// On which parts the answers to these calls depend: each is taken from one of `others`.
std::vector<Dependence> dependences(const Calls& calls, const Calls& others, const Ask& mine, const Ask& right) {
    constexpr std::size_t most = 64;
    const std::size_t count = std::min(calls.size(), most);
    const auto& parts = calls.layouts.front().parts;
    std::vector<Dependence> all(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Rows rows;
        for (std::size_t k = 0; k < count; ++k) {
            Row row = calls.rows[k];
            const std::size_t other = (k * 7 + 3) % others.size();
            for (std::size_t c = 0; c < size_of(parts[i].kind); ++c)
                row[calls.layouts[k].parts[i].at + c] = others.rows[other][others.layouts[other].parts[i].at + c];
            rows.push_back(std::move(row));
        }
        const auto differs = [&](const Rows& answers, const Rows& before) {
            double changed = 0;
            for (std::size_t k = 0; k < answers.size(); ++k) changed += !is_equal(calls.result, answers[k], before[k]);
            return answers.empty() ? 1 : changed / double(answers.size());
        };
        all[i] = {differs(mine(rows), calls.mine), differs(right(rows), calls.right)};
    }
    return all;
}

/// Calls whose numbers can be compared.
Calls compared(const Signature& signature, const Rows& rows, const Ask& mine, const Ask& right) {
    Calls calls{signature, {}, {}, {}, {}, {}, {}};
    const Rows own = mine(rows), solution = right(rows);
    if (own.size() != rows.size() || solution.size() != rows.size()) return calls;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (own[k].size() != solution[k].size()) continue;
        calls.rows.push_back(rows[k]), calls.mine.push_back(own[k]), calls.right.push_back(solution[k]);
        calls.layouts.push_back(signature.of_arguments(rows[k]));
    }
    if (calls.size() > 0) calls.result = signature.of_result(calls.right.front());
    return calls;
}

/// Calls with one number more from another call: what the checks' calls have in common by their making, a relation must
/// not rest on.
Calls crossed(const Calls& calls, const Ask& mine, const Ask& right) {
    constexpr std::size_t most = 96;
    std::vector<std::size_t> numbers;
    const auto& parts = calls.layouts.front().parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (calls.told[i] && (parts[i].kind == Kind::number || parts[i].kind == Kind::pair)) numbers.push_back(i);
    constexpr std::size_t few = 16;
    std::vector<std::size_t> wrong;
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (!is_equal(calls.result, calls.mine[k], calls.right[k])) wrong.push_back(k);
    const bool is_rare = !wrong.empty() && wrong.size() < few;
    Rows rows;
    for (std::size_t k = 0; k < std::min(most, calls.size()) && !numbers.empty(); ++k) {
        const std::size_t from = is_rare && k % 2 ? wrong[k / 2 % wrong.size()]
                                                  : k * calls.size() / std::min(most, calls.size()),
                          other = (from * 5 + 11 + (is_rare ? k : 0)) % calls.size();
        const std::size_t i = numbers[k % numbers.size()];
        Row row = calls.rows[from];
        for (std::size_t c = 0; c < size_of(parts[i].kind); ++c)
            row[calls.layouts[from].parts[i].at + c] = calls.rows[other][calls.layouts[other].parts[i].at + c];
        rows.push_back(std::move(row));
    }
    Calls all = calls, more = compared(calls.signature, rows, mine, right);
    for (std::size_t k = 0; k < more.size(); ++k) {
        if (std::ranges::any_of(more.right[k], [](double x) { return std::isnan(x); })) continue;
        all.rows.push_back(more.rows[k]), all.layouts.push_back(more.layouts[k]);
        all.mine.push_back(more.mine[k]), all.right.push_back(more.right[k]);
    }
    return all;
}

/// One answer that nearly all wrong calls get, as of a mistake by which nothing is hit.
std::string usual_wrong_answer(const Calls& calls) {
    constexpr double nearly = 0.8;
    if (calls.result.parts.front().kind == Kind::flag) return {};
    std::vector<std::size_t> wrong;
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (!is_equal(calls.result, calls.mine[k], calls.right[k])) wrong.push_back(k);
    for (std::size_t i = 0; i < std::min<std::size_t>(wrong.size(), 4); ++i) {
        const auto same = std::ranges::count_if(
            wrong, [&](std::size_t k) { return is_equal(calls.result, calls.mine[k], calls.mine[wrong[i]]); });
        if (wrong.size() >= 8 && double(same) >= nearly * double(wrong.size()))
            return fmt::format("the answer is {} in {} of {} wrong calls",
                               result_in_words(calls.signature, calls.mine[wrong[i]]), same, wrong.size());
    }
    return {};
}

std::string independence(const Calls& calls, const std::vector<Dependence>& all) {
    if (auto words = usual_wrong_answer(calls); !words.empty()) return words;
    constexpr double often = 0.2;  // what changes a few answers may be chance
    std::string lost, added;
    const auto& parts = calls.layouts.front().parts;
    const auto tell = [](std::string& list, const std::string& name) {
        list += (list.empty() ? "`" : ", `") + name + "`";
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (all[i].right > often && all[i].mine == 0) tell(lost, parts[i].name);
        if (all[i].mine > often && all[i].right == 0) tell(added, parts[i].name);
    }
    if (!lost.empty()) return fmt::format("the answer is the same whatever {} is", lost);
    if (!added.empty()) return fmt::format("the answer depends on {}, which must not matter", added);
    return {};
}

Calls only_wrong(const Calls& all) {
    return those_of(all, [&](std::size_t k) { return !is_equal(all.result, all.mine[k], all.right[k]); });
}

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

bool is_nan(const Row& mine, const Row& right) {
    const auto has_nan = [](const Row& row) {
        return std::ranges::any_of(row, [](double x) { return std::isnan(x); });
    };
    return has_nan(mine) && !has_nan(right);
}

/// The calls, of which only those count as wrong whose answer is no number.
Calls only_nan(Calls calls) {
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (!is_nan(calls.mine[k], calls.right[k])) calls.mine[k] = calls.right[k];
    return calls;
}

std::string which(const Region& region) { return (region.is_exact ? "those " : "") + region.words; }

/// What sets wrong calls apart, in arguments or in steps of the formula; in these rather than in the right answers.
Region region_of(const Calls& calls, bool is_known) {
    Region region = where_wrong(calls);
    const bool is_of_answers = region.words.starts_with("where the right ");
    return is_known || (region.is_exact && !is_of_answers) ? region : where_wrong_in_steps(calls, region);
}

/// What code takes for granted that is wrong only where it does not hold.
std::string assumption(const Region& region) {
    const std::string head = "where `|", tail = "|` is not 1";
    if (!region.is_exact || !region.words.starts_with(head) || !region.words.ends_with(tail)) return {};
    const std::size_t length = region.words.size() - head.size() - tail.size();
    return fmt::format("the length of `{}` is taken to be 1: it may have any",
                       region.words.substr(head.size(), length));
}

/// Which calls are wrong, or which are no number.
Region tell_where(Finding& finding, const Calls& all, std::size_t wrong, std::size_t not_numbers, bool is_known) {
    if (not_numbers > 0)
        if (Region region = region_of(only_nan(all), false); !region.words.empty()) {
            finding.where = fmt::format("{} of {} calls are nan, {}", not_numbers, all.size(), which(region));
            return region;
        }
    if (wrong == all.size()) return {};
    Region region = region_of(all, is_known);
    finding.where = fmt::format("{} of {} calls are wrong", wrong, all.size());
    if (not_numbers > 0) finding.where += fmt::format(", {} of them nan", not_numbers);
    if (!region.words.empty()) finding.where += ", " + which(region);
    return region;
}

/// A relation of the arguments, or of the steps of the formula; of both, where nothing tells them apart.
std::optional<Relation> simpler_one(std::optional<Relation> of_arguments, std::optional<Relation> of_steps) {
    if (!of_steps) return of_arguments;
    if (!of_arguments) return of_steps;
    if (of_steps->explains != Relation::Explains::all)
        return of_arguments->explains == Relation::Explains::all || of_arguments->share >= of_steps->share
                   ? of_arguments
                   : of_steps;
    if (of_arguments->explains != Relation::Explains::all) return of_steps;
    if (of_steps->other_numbers) return of_arguments;
    constexpr double clearly = 0.25, as_cheap = 0.5;
    const bool is_change = of_steps->words.find(as_changed) != std::string::npos, everywhere = of_steps->everywhere;
    if (is_change && everywhere && !of_arguments->everywhere) return of_steps;
    if (is_change && of_steps->cost < of_arguments->cost - clearly) return of_steps;
    if (!of_steps->words.starts_with(as_changed) || !of_arguments->words.starts_with(as_changed) ||
        of_steps->cost > of_arguments->cost + as_cheap)
        return of_arguments;
    // a mistake with a name, which no change of an argument has
    if (of_steps->words[as_changed.size()] != '`') return of_steps;
    if (of_steps->words.starts_with(of_arguments->words + ",")) {
        of_steps->usually = of_arguments->usually;
        return of_steps;
    }
    if (of_steps->cost < of_arguments->cost) std::swap(of_steps, of_arguments);
    of_arguments->words += ", or with " + of_steps->words.substr(as_changed.size());
    return of_arguments;
}

std::optional<Relation> simpler(const std::optional<Relation>& of_arguments, const std::optional<Relation>& of_steps) {
    const auto is_exact = [](const auto& found) { return found && found->explains == Relation::Explains::all; };
    auto one = simpler_one(of_arguments, of_steps);
    if (one) one->by_arguments = is_exact(of_arguments), one->by_steps = is_exact(of_steps);
    return one;
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
    if (wrong > 0) found = simpler(found, relation_of_steps(*own, right, false));
    if (found && found->explains == Relation::Explains::all) return found->words + found->usually;
    if (wrong > 0) return {};
    const auto place = std::ranges::find_if(own->result.parts, is_place),
               measure = std::ranges::find_if_not(own->result.parts, is_place);
    const auto spread = spread_of(all, all, mine, right);
    if (!spread || measure == own->result.parts.end()) return {};
    return fmt::format("each `{}` is right for its `{}`, but these are not spread so: {}", measure->name, place->name,
                       *spread);
}

/// What is wrong where the answer is a number.
std::string of_numbers(const Calls& calls, const Ask& right, bool sampled) {
    const Calls some = those_of(calls, [&](std::size_t k) { return !is_nan(calls.mine[k], calls.right[k]); });
    bool right_otherwise = false;
    auto found = some.size() > 0 ? relation_of(some, right, sampled, right_otherwise) : std::nullopt;
    if (some.size() > 0) found = simpler(found, relation_of_steps(some, right, sampled));
    const std::string words = "some answers are nan where the right one is a number";
    if (!found || found->explains != Relation::Explains::all) return words;
    return fmt::format("{}; where it is a number, {}", words, found->words + found->usually);
}

/// The relation that is found in some of the calls, and found again in others: what holds by chance is not.
std::optional<Relation> sure_relation(const Calls& calls, const Ask& right, const Ask& ask_right, bool sampled,
                                      bool& right_otherwise) {
    const auto found = [&](bool others, const Ask& ask, std::size_t most = most_compared) {
        const Calls some = picked(calls, most, others);
        auto relation = relation_of(some, ask, sampled, right_otherwise);
        return right_otherwise ? std::nullopt : simpler(relation, relation_of_steps(some, ask, sampled));
    };
    auto relation = found(false, right);
    if (!relation || relation->explains != Relation::Explains::all) return relation;
    std::size_t left = most_calls;
    const auto again = found(true, limited(ask_right, left));
    return again && again->words != relation->words ? found(false, limited(ask_right, left), 2 * most_compared)
                                                    : relation;
}

/// The simplest wrong call. Of a sample there may be more than one right place, unless it is told what is done
/// otherwise.
void add_example(Finding& finding, const Calls& all, const Region& region, bool is_one_right, const Ask& ask_mine,
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

}  // namespace

Finding explain(const Signature& signature, const Rows& rows, const Ask& ask_mine, const Ask& ask_right) try {
    std::size_t left = most_calls;
    const Ask mine = limited(ask_mine, left), right = limited(ask_right, left);
    Calls all = compared(signature, rows, mine, right);
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < all.size(); ++k) wrong += !is_equal(all.result, all.mine[k], all.right[k]);
    bool is_near = true;
    constexpr double nearly = 1e-3;
    for (std::size_t k = 0; k < all.size(); ++k)
        is_near = is_near && is_alike(all.result, all.mine[k], all.right[k], nearly);
    Finding finding;
    if (is_near) finding.how = small_offsets(all);
    if (wrong == 0) return finding;
    const auto depends = dependences(all, all, mine, right);
    for (const Dependence& d : depends) all.told.push_back(d.mine > 0 || d.right > 0);

    const auto& arguments = signature.arguments;
    const bool sampled = std::ranges::any_of(arguments, [](const auto& argument) { return argument.name == "u"; });
    bool right_otherwise = false;
    const Calls many_calls = crossed(all, mine, right);
    auto relation = sure_relation(many_calls, right, ask_right, sampled, right_otherwise);
    if (right_otherwise) return {};
    finding.sampled = sampled;
    if (relation) relation->words += relation->usually;
    const bool is_known = relation && relation->explains == Relation::Explains::all;
    if (is_known) finding.by_arguments = relation->by_arguments, finding.by_steps = relation->by_steps;
    const bool is_nothing = !relation || relation->explains == Relation::Explains::nothing;
    const auto broken = is_nothing ? broken_bound(all, right) : std::nullopt;
    std::size_t not_numbers = 0;
    for (std::size_t k = 0; k < all.size(); ++k) not_numbers += is_nan(all.mine[k], all.right[k]);
    constexpr double most = 0.9;
    const bool is_mostly_known = is_known || (relation && !is_nothing && relation->share >= most);
    if (finding.how.empty() && (not_numbers > 0 ? !is_known : !is_mostly_known))
        finding.how = not_numbers > 0 ? of_numbers(picked(many_calls, most_compared), right, sampled)
                      : !sampled      ? wrong_shares(all, mine, right)
                      : broken        ? ""
                                      : of_own_numbers(all, mine, right);
    if (finding.how.empty())
        finding.how = broken ? broken->words : is_nothing ? independence(all, depends) : relation->words;
    if (finding.how.empty() && relation) finding.how = relation->words;
    // Another parametrisation is wrong in no call. Where many answers are the solution's, the random numbers are used
    // as the solution does, but perhaps not in calls of one kind.
    constexpr double many = 0.2;
    const bool is_comparable = !sampled || not_numbers > 0 || double(all.size() - wrong) >= many * double(all.size());
    if (!is_comparable && !relation) return of_samples(finding, all, broken, ask_mine, ask_right);
    if (sampled && finding.how.empty()) finding.how = spread_of(only_wrong(all), all, mine, right).value_or("");

    const Region region =
        is_comparable ? tell_where(finding, with_parts_that_matter(all, mine, right), wrong, not_numbers, is_known)
                      : Region{};
    if (const std::string words = assumption(region); !words.empty() && !is_known) finding.how = words;
    const bool is_exact = relation && !is_nothing && (is_known || relation->everywhere);
    add_example(finding, all, region, !sampled || is_exact || not_numbers > 0, ask_mine, ask_right);
    return finding;
} catch (const std::out_of_range&) {
    return {};  // an answer that is too short
}

}  // namespace grade
