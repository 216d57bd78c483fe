#include "diagnosis/right_otherwise.h"

#include <map>
#include <set>

#include "diagnosis/scalars.h"

namespace grade {

namespace {

using rt::vec3;

/// Where in a row of arguments, or of results, a part stands; none: there is no such part.
template <class Found>
std::optional<std::size_t> place_of(const Layout& layout, Found is_found) {
    const auto part = std::ranges::find_if(layout.parts, is_found);
    return part == layout.parts.end() ? std::nullopt : std::optional(part->at);
}

/// Integrals of 1, of the direction and of its squared distance from a middle, over what the samples of a call stand
/// for: the means of x / density.
struct Integrals {
    double all = 0, square = 0;
    vec3 direction{0};
};

Integrals integrals(const Rows& answers, std::size_t begin, std::size_t count, std::size_t direction,
                    std::size_t density, vec3 middle) {
    Integrals sum;
    for (std::size_t k = begin; k < begin + count; ++k) {
        const double share = 1 / answers[k][density] / double(count);
        if (!(answers[k][density] > 0)) continue;
        const vec3 d = vector_at(answers[k], direction);
        sum.all += share, sum.direction += share * d, sum.square += share * rt::dot(d - middle, d - middle);
    }
    return sum;
}

/// Whether samples are somewhere else than the solution's for the same random numbers: further off than a fourth of how
/// far these are apart. A place that is right but for some percent is the same one, and wrong.
bool are_elsewhere(const Rows& own, const Rows& due, std::size_t begin, std::size_t count, std::size_t direction) {
    vec3 mean(0);
    for (std::size_t k = begin; k < begin + count; ++k) mean += vector_at(due[k], direction) / double(count);
    double apart = 0, spread = 0;
    for (std::size_t k = begin; k < begin + count; ++k) {
        apart += glm::length(vector_at(own[k], direction) - vector_at(due[k], direction));
        spread += glm::length(vector_at(due[k], direction) - mean);
    }
    return apart > 0.25 * spread;
}

/// Whether samples over the square of u, of some of these calls, integrate as they must.
bool integrate_alike(const Rows& calls, std::size_t u, std::size_t direction, std::size_t density, const Ask& mine,
                     const Ask& right) {
    constexpr std::size_t bases = 6, side = 32, count = side * side;
    constexpr double close = 0.05;  // what a grid of points leaves at the rim of a lamp
    Rows rows;
    const std::size_t some = std::min(bases, calls.size());
    for (std::size_t base = 0; base < some; ++base)
        for (std::size_t i = 0; i < count; ++i) {
            rows.push_back(calls[base * calls.size() / some]);
            rows.back()[u] = (double(i % side) + 0.5) / side, rows.back()[u + 1] = (double(i / side) + 0.5) / side;
        }
    const Rows own = mine(rows), due = right(rows);
    if (own.size() != rows.size() || due.size() != rows.size()) return false;
    bool any = false;
    for (std::size_t base = 0; base < some; ++base) {
        const auto of = [&](const Rows& answers, vec3 middle) {
            return integrals(answers, base * count, count, direction, density, middle);
        };
        const Integrals whole = of(due, vec3(0));
        if (whole.all == 0) continue;
        const vec3 middle = whole.direction / whole.all;
        const Integrals a = of(own, middle), b = of(due, middle);
        if (!(std::abs(a.all - b.all) <= close * b.all)) return false;
        if (!(glm::length(a.direction - b.direction) <= close * b.all)) return false;
        if (!(std::abs(a.square - b.square) <= 2 * close * b.square)) return false;
        if (!are_elsewhere(own, due, base * count, count, direction)) return false;
        any = true;
    }
    return any;
}

}  // namespace

Ask without_right_ones(const Signature& signature, const Rows& rows, const Ask& mine, const Ask& right) {
    if (rows.empty()) return mine;
    const Layout arguments = signature.of_arguments(rows.front());
    const auto choice = place_of(arguments, [](const Field&part) { return part.kind == Kind::choice; }),
               u = place_of(arguments, [](const Field&part) { return part.name == "u" && part.kind == Kind::pair; });
    if (!choice || !u) return mine;
    const Rows answer = right({rows.front()});
    if (answer.size() != 1) return mine;
    const Layout result = signature.of_result(answer.front());
    const auto direction = place_of(result, [](const Field&part) { return part.kind == Kind::vector; }),
               density = place_of(result, [](const Field&part) { return part.name == "density"; });
    if (!direction || !density) return mine;

    std::map<double, Rows> by_value;
    for (const Row& row : rows) by_value[row[*choice]].push_back(row);
    std::set<double> right_ones;
    for (const auto& [value, calls] : by_value)
        if (integrate_alike(calls, *u, *direction, *density, mine, right)) right_ones.insert(value);
    if (right_ones.empty()) return mine;
    return [=](const Rows& asked) {
        Rows answers = mine(asked);
        if (answers.size() != asked.size()) return answers;
        Rows others;
        std::vector<std::size_t> which;
        for (std::size_t k = 0; k < asked.size(); ++k)
            if (right_ones.contains(asked[k][*choice])) others.push_back(asked[k]), which.push_back(k);
        const Rows due = others.empty() ? Rows{} : right(others);
        for (std::size_t i = 0; i < due.size(); ++i) answers[which[i]] = due[i];
        return answers;
    };
}

}  // namespace grade
