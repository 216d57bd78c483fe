#include "diagnosis/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/bounds.h"
#include "diagnosis/by_steps.h"
#include "diagnosis/relation.h"
#include "diagnosis/shares.h"
#include "diagnosis/simplest.h"
#include "diagnosis/spread.h"
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

/// Calls of which `most` are picked evenly, as many wrong as right ones where there are.
Calls picked(const Calls& all, std::size_t most) {
    std::vector<std::size_t> wrong, good;
    for (std::size_t k = 0; k < all.size(); ++k)
        (is_equal(all.result, all.mine[k], all.right[k]) ? good : wrong).push_back(k);
    const auto thin = [](std::vector<std::size_t> from, std::size_t count) {
        if (from.size() <= count) return from;
        std::vector<std::size_t> some;
        for (std::size_t i = 0; i < count; ++i) some.push_back(from[i * from.size() / count]);
        return some;
    };
    const std::size_t of_right = std::min(good.size(), most - std::min(wrong.size(), most * 2 / 3));
    std::vector<std::size_t> chosen = thin(wrong, most - of_right);
    for (const std::size_t k : thin(good, of_right)) chosen.push_back(k);
    Calls some{all.signature, {}, {}, {}, {}, all.result, all.told};
    for (const std::size_t k : chosen) {
        some.rows.push_back(all.rows[k]), some.layouts.push_back(all.layouts[k]);
        some.mine.push_back(all.mine[k]), some.right.push_back(all.right[k]);
    }
    return some;
}

/// In what share of the calls an answer changes with a part.
struct Dependence {
    double mine = 0, right = 0;
};

/// On which parts the answers depend: each is taken from another call.
std::vector<Dependence> dependences(const Calls& calls, const Ask& mine, const Ask& right) {
    const std::size_t count = std::min<std::size_t>(calls.size(), 32);
    const auto& parts = calls.layouts.front().parts;
    std::vector<Dependence> all(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Rows rows;
        for (std::size_t k = 0; k < count; ++k) {
            Row row = calls.rows[k];
            const std::size_t other = (k * 7 + 3) % calls.size();
            for (std::size_t c = 0; c < size_of(parts[i].kind); ++c)
                row[calls.layouts[k].parts[i].at + c] = calls.rows[other][calls.layouts[other].parts[i].at + c];
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
    Rows rows;
    for (std::size_t k = 0; k < std::min(most, calls.size()) && !numbers.empty(); ++k) {
        const std::size_t from = k * calls.size() / std::min(most, calls.size()),
                          other = (from * 5 + 11) % calls.size();
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
    Calls some{all.signature, {}, {}, {}, {}, all.result, all.told};
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (is_equal(all.result, all.mine[k], all.right[k])) continue;
        some.rows.push_back(all.rows[k]), some.layouts.push_back(all.layouts[k]);
        some.mine.push_back(all.mine[k]), some.right.push_back(all.right[k]);
    }
    return some;
}

/// The calls, of which only those parts are told that an answer to a wrong call depends on.
Calls with_parts_that_matter(Calls calls, const Ask& mine, const Ask& right) {
    const Calls wrong = only_wrong(calls);
    if (wrong.size() == 0) return calls;
    const auto depends = dependences(wrong, mine, right);
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

/// Which calls are wrong, or which are no number.
Region tell_where(Finding& finding, const Calls& all, std::size_t wrong, std::size_t not_numbers) {
    if (not_numbers > 0)
        if (Region region = where_wrong(only_nan(all)); !region.words.empty()) {
            finding.where = fmt::format("{} of {} calls are nan, those {}", not_numbers, all.size(), region.words);
            return region;
        }
    if (wrong == all.size()) return {};
    Region region = where_wrong(all);
    finding.where = fmt::format("{} of {} calls are wrong", wrong, all.size());
    if (not_numbers > 0) finding.where += fmt::format(", {} of them nan", not_numbers);
    if (!region.words.empty()) finding.where += ", those " + region.words;
    return region;
}

/// A relation of the arguments, or of the steps of the formula; of both, where nothing tells them apart.
std::optional<Relation> simpler(std::optional<Relation> of_arguments, std::optional<Relation> of_steps) {
    if (!of_steps) return of_arguments;
    if (!of_arguments || of_arguments->explains != Relation::Explains::all) return of_steps;
    constexpr double clearly = 0.5, as_cheap = 0.5;
    const bool is_change = of_steps->words.starts_with(as_changed), everywhere = of_steps->everywhere;
    if (is_change && everywhere && !of_arguments->everywhere) return of_steps;
    if (is_change && of_steps->cost < of_arguments->cost - clearly) return of_steps;
    if (is_change && of_arguments->words.starts_with(as_changed) && of_steps->cost <= of_arguments->cost + as_cheap)
        of_arguments->words += "; or with " + of_steps->words.substr(as_changed.size());
    return of_arguments;
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
    const auto spread = spread_of(all, limited(ask_mine, left), limited(ask_right, left));
    if (finding.how.empty()) finding.how = spread.value_or("");
    return finding;
}

}  // namespace

Finding explain(const Signature& signature, const Rows& rows, const Ask& ask_mine, const Ask& ask_right) try {
    std::size_t left = most_calls;
    const Ask mine = limited(ask_mine, left), right = limited(ask_right, left);
    Calls all = compared(signature, rows, mine, right);
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < all.size(); ++k) wrong += !is_equal(all.result, all.mine[k], all.right[k]);
    if (wrong == 0) return {};
    const auto depends = dependences(all, mine, right);
    for (const Dependence& d : depends) all.told.push_back(d.mine > 0 || d.right > 0);

    const auto& arguments = signature.arguments;
    const bool sampled = std::ranges::any_of(arguments, [](const auto& argument) { return argument.name == "u"; });
    bool right_otherwise = false;
    Finding finding;
    const Calls compared_calls = picked(crossed(all, mine, right), most_compared);
    auto relation = relation_of(compared_calls, right, sampled, right_otherwise);
    if (right_otherwise) return {};
    relation = simpler(std::move(relation), relation_of_steps(compared_calls, right, sampled));
    finding.sampled = sampled;
    const bool is_known = relation && relation->explains == Relation::Explains::all;
    const bool is_nothing = !relation || relation->explains == Relation::Explains::nothing;
    const auto broken = is_nothing ? broken_bound(all) : std::nullopt;
    std::size_t not_numbers = 0;
    for (std::size_t k = 0; k < all.size(); ++k) not_numbers += is_nan(all.mine[k], all.right[k]);
    if (not_numbers > 0 && !is_known)
        finding.how = "some answers are nan where the right one is a number";
    else if (!is_known)
        finding.how = wrong_shares(all, mine, right);
    if (finding.how.empty())
        finding.how = broken ? broken->words : is_nothing ? independence(all, depends) : relation->words;
    if (finding.how.empty() && relation) finding.how = relation->words;
    // another parametrisation is wrong in no call
    // but where many are the solution's, the random numbers are used as the solution does
    constexpr double many = 0.2;
    const bool is_comparable = !sampled || not_numbers > 0 || double(all.size() - wrong) >= many * double(all.size());
    if (!is_comparable && !relation) return of_samples(finding, all, broken, ask_mine, ask_right);
    if (sampled && finding.how.empty()) finding.how = spread_of(only_wrong(all), mine, right).value_or("");

    const Region region =
        is_comparable ? tell_where(finding, with_parts_that_matter(all, mine, right), wrong, not_numbers) : Region{};
    std::size_t more = 4000;
    const Ask mine_again = limited(ask_mine, more), right_again = limited(ask_right, more);
    const Example simplest = simplest_wrong(all, region, mine_again, right_again);
    std::vector<bool> wrong_parts;
    for (const Field& part : all.result.parts) wrong_parts.push_back(!is_equal(part, simplest.mine, simplest.right));
    finding.answer = result_in_words(signature, simplest.mine, wrong_parts);
    finding.right = result_in_words(signature, simplest.right, wrong_parts);
    add_call(finding, signature, simplest);
    return finding;
} catch (const std::out_of_range&) {
    return {};  // an answer that is too short
}

}  // namespace grade
