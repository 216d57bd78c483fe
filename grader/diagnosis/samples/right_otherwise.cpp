#include "diagnosis/samples/right_otherwise.h"

#include <map>
#include <set>

#include "diagnosis/samples/integrals.h"

namespace grade {

namespace {

/// Whether samples of some of these calls, over all random numbers, are right and lie elsewhere than the solution's.
bool are_right_elsewhere(const Calls& calls, const Ask& mine, const Ask& right) {
    constexpr std::size_t bases = 6, side = 32;
    constexpr double close = 0.05;  // what a grid of points leaves at the rim of a lamp
    const auto integrals = Integrals::of(calls, right, std::min(bases, calls.size()), side, close);
    if (!integrals) return false;
    const Rows answers = mine(integrals->rows());
    return integrals->are_right(answers) && integrals->are_elsewhere(answers);
}

}  // namespace

Ask without_right_ones(const Signature& signature, const Rows& rows, const Ask& mine, const Ask& right) {
    if (rows.empty()) return mine;
    const Layout arguments = signature.of_arguments(rows.front());
    const auto choice = std::ranges::find(arguments.parts, Kind::choice, &Field::kind);
    if (choice == arguments.parts.end() || std::ranges::count(arguments.parts, "u", &Field::name) == 0) return mine;
    const Rows answer = right({rows.front()});
    if (answer.size() != 1) return mine;
    const Layout result = signature.of_result(answer.front());
    if (std::ranges::count(result.parts, "density", &Field::name) == 0) return mine;

    std::map<double, Calls> by_value;
    for (const Row& row : rows) {
        Calls& calls =
            by_value.try_emplace(row[choice->at], Calls{signature, {}, {}, {}, {arguments}, result, {}}).first->second;
        calls.rows.push_back(row);
    }
    std::set<double> right_ones;
    for (const auto& [value, calls] : by_value)
        if (are_right_elsewhere(calls, mine, right)) right_ones.insert(value);
    if (right_ones.empty()) return mine;
    return [=, at = choice->at](const Rows& asked) {
        Rows answers = mine(asked);
        if (answers.size() != asked.size()) return answers;
        Rows others;
        std::vector<std::size_t> which;
        for (std::size_t k = 0; k < asked.size(); ++k)
            if (right_ones.contains(asked[k][at])) others.push_back(asked[k]), which.push_back(k);
        const Rows due = others.empty() ? Rows{} : right(others);
        for (std::size_t i = 0; i < due.size(); ++i) answers[which[i]] = due[i];
        return answers;
    };
}

}  // namespace grade
