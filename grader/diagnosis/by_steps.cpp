#include "diagnosis/by_steps.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/changes.h"
#include "diagnosis/steps.h"

namespace grade {

namespace {

/// Whether any answer depends on a step; some are there to be taken in place of others.
bool is_used(const Calls& calls, const Steps& steps, std::size_t part) {
    for (std::size_t k = 0; k < calls.size(); ++k) {
        const Field& field = calls.layouts[k].parts[part];
        for (std::size_t c = 0; c < size_of(field.kind); ++c) {
            Row row = calls.rows[k];
            double& x = row[field.at + c];
            x = field.kind == Kind::flag ? 1 : field.kind == Kind::whole ? x + 1 : 0.7 * x - 0.3;
            if (!is_equal(calls.result, steps.finish(row), calls.right[k])) return true;
        }
    }
    return false;
}

Row behind(Row row, const Row& more) {
    row.insert(row.end(), more.begin(), more.end());
    return row;
}

/// The calls in which the formula is the solution's, with its steps behind the arguments.
Calls with_steps(const Calls& calls, const Steps& steps) {
    Calls all = calls;
    for (auto* list : {&all.rows, &all.mine, &all.right}) list->clear();
    all.layouts.clear();
    all.signature.arguments.insert(all.signature.arguments.end(), steps.names.begin(), steps.names.end());
    for (std::size_t k = 0; k < calls.size(); ++k) {
        Row row = behind(calls.rows[k], steps.take(calls.rows[k])), answer = steps.finish(row);
        if (answer.size() > calls.right[k].size() || !is_equal(calls.result, answer, calls.right[k])) continue;
        all.layouts.push_back(all.signature.of_arguments(row));
        all.rows.push_back(std::move(row)), all.mine.push_back(calls.mine[k]);
        all.mine.back().resize(answer.size());  // a function among the arguments adds what it was asked for
        all.right.push_back(std::move(answer));
    }
    if (all.size() == 0) return all;
    const std::size_t arguments = calls.layouts.front().parts.size();
    all.told.resize(all.layouts.front().parts.size(), true);
    for (std::size_t i = 0; i < all.told.size(); ++i)
        all.changeable.push_back(i >= arguments && is_used(all, steps, i));
    return all;
}

/// Whether words speak of a step.
bool mentions(const std::string& words, const Steps& steps) {
    return std::ranges::any_of(steps.names,
                               [&](const auto& name) { return words.find(name.name) != std::string::npos; });
}

/// The calls with other random numbers, and the right answers to these.
Calls with_numbers(const Calls& calls, const Change& base, const Ask& right) {
    Calls all = calls;
    if (base.cost == 0) return all;
    for (std::size_t k = 0; k < all.size(); ++k) base.make(all.rows[k], all.layouts[k]);
    all.right = right(all.rows);
    if (all.right.size() != all.rows.size()) all.rows.clear();
    return all;
}

}  // namespace

std::optional<Relation> relation_of_steps(const Calls& calls, const Ask& right, bool sampled) {
    constexpr double least = 0.9;  // of the calls, in which the formula must be the solution's
    const std::vector<Steps> cuts = steps_of(calls.signature.fragment);
    constexpr std::size_t enough = 5;  // wrong calls
    std::optional<Relation> best, some;
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < calls.size(); ++k) wrong += !is_equal(calls.result, calls.mine[k], calls.right[k]);
    if (cuts.empty() || wrong < enough) return best;
    for (const Change& base : same_sampling(calls.layouts.front())) {
        if (base.cost > 0 && !sampled) break;
        const Calls numbered = with_numbers(calls, base, right);
        for (const Steps& steps : cuts) {
            const Calls all = with_steps(numbered, steps);
            if (double(all.size()) < least * double(calls.size())) continue;
            const Ask finish = [&steps](const Rows& rows) {
                Rows answers;
                for (const Row& row : rows) answers.push_back(steps.finish(row));
                return answers;
            };
            bool right_otherwise = false;
            auto found = relation_of(all, finish, false, right_otherwise);
            if (!found) continue;
            if (!steps.formula.empty() && mentions(found->words, steps))
                found->words.insert(std::min(found->words.find(other_mistakes), found->words.size()),
                                    fmt::format(", in `{}`", steps.formula));
            if (found->explains != Relation::Explains::all) {
                if (base.cost == 0 && (!some || some->share < found->share)) some = std::move(found);
                continue;
            }
            found->cost += base.cost, found->other_numbers = base.cost > 0;
            if (!best || best->cost > found->cost) best = std::move(found);
        }
        if (best) break;
    }
    return best ? best : some;
}

namespace {

/// The first calls that are wrong, with their arguments changed, once for each of the changes.
std::vector<Calls> changed_calls(const Calls& calls, const std::vector<Change>& changes, const Ask& right) {
    constexpr std::size_t few = 4;
    const Calls wrong =
        those_of(calls, [&](std::size_t k) { return !is_equal(calls.result, calls.mine[k], calls.right[k]); });
    const std::size_t step = std::max<std::size_t>(wrong.size() / few, 1);
    const Calls some = those_of(wrong, [&](std::size_t k) { return k % step == 0 && k / step < few; });
    std::vector<Calls> all;
    Rows rows;
    for (const Change& change : changes) {
        all.push_back(some);
        for (std::size_t k = 0; k < some.size(); ++k) {
            if (!change.make(all.back().rows[k], some.layouts[k]) || all.back().rows[k].size() != some.rows[k].size())
                all.back().rows[k] = some.rows[k];
            rows.push_back(all.back().rows[k]);
        }
    }
    const Rows answers = right(rows);
    if (answers.size() != rows.size()) return {};
    for (std::size_t i = 0; i < answers.size(); ++i) all[i / some.size()].right[i % some.size()] = answers[i];
    return all;
}

bool are_equal(const Calls& calls, const Change& change, const Steps& steps) {
    for (std::size_t k = 0; k < calls.size(); ++k) {
        Row row = calls.rows[k];
        if (!change.make(row, calls.layouts[k])) return false;
        const Row answer = steps.finish(row);
        if (answer.size() > calls.mine[k].size() || !is_equal(calls.result, answer, calls.mine[k])) return false;
    }
    return calls.size() > 0;
}

}  // namespace

std::optional<Relation> relation_of_both(const Calls& calls, const Ask& right) {
    constexpr double dearest = 1.5;
    std::vector<Change> bases = changes_of(calls.layouts.front(), calls.told);
    std::erase_if(bases, [](const Change& change) { return change.cost > dearest; });
    const std::vector<Calls> some = changed_calls(calls, bases, right);
    for (std::size_t b = 0; b < some.size(); ++b)
        for (const Steps& steps : steps_of(calls.signature.fragment)) {
            const Calls few = with_steps(some[b], steps);
            if (few.size() < some[b].size() || few.size() < 2) continue;
            for (const Change& change : changes_of(few.layouts.front(), few.told, few.changeable)) {
                if (change.cost > dearest) break;
                if (!are_equal(few, change, steps)) continue;
                const Calls all = with_steps(with_numbers(calls, bases[b], right), steps);
                if (all.size() < calls.size() || !are_equal(all, change, steps)) continue;
                Relation both{std::string(as_changed) + bases[b].words + ", and " + change.words};
                if (!steps.formula.empty()) both.words += fmt::format(", in `{}`", steps.formula);
                both.by_arguments = both.by_steps = true;
                return both;
            }
        }
    return std::nullopt;
}

WrongCalls where_wrong_in_steps(const Calls& calls, WrongCalls otherwise) {
    for (const Steps& steps : steps_of(calls.signature.fragment)) {
        Calls all = calls;
        all.signature.arguments.insert(all.signature.arguments.end(), steps.names.begin(), steps.names.end());
        for (std::size_t k = 0; k < calls.size(); ++k) {
            all.rows[k] = behind(calls.rows[k], steps.take(calls.rows[k]));
            all.layouts[k] = all.signature.of_arguments(all.rows[k]);
        }
        WrongCalls region = where_wrong(all, false);
        if (!region.is_exact || !mentions(region.words, steps)) continue;
        if (!steps.formula.empty()) region.words += fmt::format(", in `{}`", steps.formula);
        region.holds = [holds = region.holds, take = steps.take, signature = all.signature](
                           const Row& row, const Layout&, const Row& right) {
            const Row all_numbers = behind(row, take(row));
            return holds(all_numbers, signature.of_arguments(all_numbers), right);
        };
        return region;
    }
    return otherwise;
}

}  // namespace grade
