#include "diagnosis/where/features_of_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "diagnosis/calls/arguments.h"

namespace grade {

namespace {

using Holds = std::function<bool(const double* x)>;

bool is_zero_vector(const double* x) { return x[0] == 0 && x[1] == 0 && x[2] == 0; }

bool has_zero_channel(const double* x) { return x[0] == 0 || x[1] == 0 || x[2] == 0; }

Feature of_part(std::size_t i, const std::string& words, Holds holds) {
    return {words, [i, holds = std::move(holds)](const Row& row, const Layout& layout, const Row&) {
                return holds(&row[layout.parts[i].at]);
            }};
}

/// That a choice is one of those that wrong calls have.
Feature of_choice(const Calls& calls, const std::vector<bool>& wrong, std::size_t i) {
    const Field& part = calls.layouts.front().parts[i];
    std::set<double> bad;
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (wrong[k]) bad.insert(calls.rows[k][calls.layouts[k].parts[i].at]);
    std::string words;
    for (const double value : bad)
        words += (words.empty() ? "" : " or ") + value_in_words({part.name, part.kind, 0}, {value});
    return of_part(i, fmt::format("`{}` is {}", part.name, words),
                   [bad](const double* x) { return bad.contains(x[0]); });
}

}  // namespace

std::vector<Feature> features_of_parts(const Calls& calls, const std::vector<bool>& wrong,
                                       const std::vector<bool>& told) {
    std::vector<Feature> all;
    const auto& parts = calls.layouts.front().parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!told[i]) continue;
        const Field& part = parts[i];
        const auto add = [&](const char* is, Holds holds) {
            all.push_back(of_part(i, fmt::format(fmt::runtime(is), part.name), std::move(holds)));
        };
        if (part.kind == Kind::flag) {
            add("`{}` is true", [](const double* x) { return x[0] != 0; });
            add("`{}` is false", [](const double* x) { return x[0] == 0; });
        }
        if (part.kind == Kind::choice) all.push_back(of_choice(calls, wrong, i));
        if (part.kind == Kind::color || part.kind == Kind::vector) {
            add("`{} = (0, 0, 0)`", is_zero_vector);
            add("`{}` is not (0, 0, 0)", std::not_fn(is_zero_vector));
        }
        if (part.kind == Kind::color) add("a channel of `{}` is 0", has_zero_channel);
    }
    return all;
}

std::vector<Feature> features_of_axes(const std::vector<Direction>& directions) {
    std::vector<Feature> all;
    for (const Direction& one : directions)
        for (int axis = 0; axis < 3; ++axis) {
            all.push_back({fmt::format("{} is along the {} axis", one.words, "xyz"[axis]),
                           [axis, value = one.value](const Row& row, const Layout& layout, const Row&) {
                               constexpr double close = 1e-9;
                               return std::abs(std::abs(value(row, layout)[axis]) - 1) < close;
                           }});
            all.back().is_of_axis = true;
        }
    return all;
}

std::vector<Feature> features_of_answers(const Layout& result) {
    std::vector<Feature> all;
    for (const Field& part : result.parts) {
        const auto add = [&](const char* is, Holds holds) {
            all.push_back({fmt::format("the right {} is {}", part.name.empty() ? "answer" : part.name, is),
                           [at = part.at, holds = std::move(holds)](const Row&, const Layout&, const Row& right) {
                               return holds(&right[at]);
                           },
                           true});
        };
        const Holds is_zero = [size = size_of(part.kind)](const double* x) {
            return std::all_of(x, x + size, [](double y) { return y == 0; });
        };
        const bool is_flag = part.kind == Kind::flag;
        add(is_flag ? "false" : "0", is_zero);
        add(is_flag ? "true" : "not 0", std::not_fn(is_zero));
        add("inf", [](const double* x) { return std::isinf(*x); });
        add("not inf", [](const double* x) { return std::isfinite(*x); });
    }
    return all;
}

}  // namespace grade
