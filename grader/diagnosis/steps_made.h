#pragma once

#include <algorithm>
#include <tuple>

#include "diagnosis/steps.h"
#include "protocol/rows.h"
#include "rt/math.h"

namespace grade {

/// "Real x; bool a mistake in words"
inline std::vector<Signature::Argument> named(const std::string& text) {
    std::vector<Signature::Argument> all;
    for (std::size_t at = 0, next; at < text.size(); at = next + 2) {
        next = std::min(text.find("; ", at), text.size());
        const std::size_t space = text.find(' ', at);
        all.push_back({text.substr(at, space - at), text.substr(space + 1, next - space - 1)});
    }
    return all;
}

inline std::size_t count_of(const std::vector<Signature::Argument>& names) {
    std::size_t count = 0;
    for (const auto& name : names)
        count += name.type == "vec3" || name.type == "Color" ? 3 : name.type == "vec2" ? 2 : 1;
    return count;
}

/// take(arguments...) makes the steps, finish(steps, arguments...) the answer.
template <class... Arguments>
Steps steps(const char* formula, const char* numbers, Row (*take)(const Arguments&...),
            Row (*finish)(const double* steps, const Arguments&...)) {
    const auto names = named(numbers);
    const std::size_t count = count_of(names);
    const auto arguments = [](const Row& in) {
        RowReader reader(in);
        return std::tuple<Arguments...>{read(reader, Tag<Arguments>{})...};
    };
    return {formula, names, [=](const Row& in) { return std::apply(take, arguments(in)); },
            [=](const Row& in) {
                return std::apply([&](const Arguments&... each) { return finish(&in[in.size() - count], each...); },
                                  arguments(in));
            }};
}

/// The same, its direction normalised, as careful code does.
inline Steps normalised(Steps of) {
    const std::size_t end = of.formula.find(", ");
    if (of.formula.find(" = ") > end) of.formula = "unit(" + of.formula.substr(0, end) + ")" + of.formula.substr(end);
    of.finish = [finish = std::move(of.finish)](const Row& in) {
        Row answer = finish(in);
        const rt::vec3 direction = rt::unit({answer[0], answer[1], answer[2]});
        for (int c = 0; c < 3; ++c) answer[std::size_t(c)] = direction[c];
        return answer;
    };
    return of;
}

/// A point of the unit circle, at a share of a turn, and of the unit disk, as the solution puts it there.
inline rt::vec2 circle_of(double turn) { return {std::cos(2 * rt::pi * turn), std::sin(2 * rt::pi * turn)}; }
inline rt::vec2 on_disk(rt::vec2 u) { return std::sqrt(u.x) * circle_of(u.y); }

std::vector<Steps> steps_of_integrals(const std::string& fragment);
std::vector<Steps> steps_of_rays(const std::string& fragment);
std::vector<Steps> steps_of_light(const std::string& fragment);
std::vector<Steps> steps_of_warps(const std::string& fragment);
std::vector<Steps> steps_of_lamps(const std::string& fragment);
std::vector<Steps> steps_of_lobes(const std::string& fragment);
std::vector<Steps> steps_of_distribution(const std::string& fragment);

}  // namespace grade
