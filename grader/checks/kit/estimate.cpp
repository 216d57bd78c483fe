#include "checks/kit/estimate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "statistics/moments.h"
#include "statistics/tests.h"

namespace grade {

Statistic mean_of(const Mean& m) {
    const double unit = m.unit.value_or(m.truth != 0 ? m.truth : 1);
    return {.id = m.id,
            .what = m.what,
            .measure =
                [number = m.number](const Observation& seen) {
                    Moments mean;
                    for (std::size_t k = 0; k < seen.inputs.size(); ++k)
                        mean.add(number(seen.inputs[k], seen.outputs[k]));
                    return mean.mean;
                },
            .truth = m.truth,
            .delta0 = m.delta0.value_or(0.001 * unit),
            .delta = m.delta.value_or(0.05 * unit),
            .hint = m.hint,
            .cause = m.cause};
}

Statistic find_half_a_percent(Statistic mean) {
    mean.delta0 = 0.0005 * *mean.truth;
    mean.delta = 0.0045 * *mean.truth;  // where there is no noise, what is not above it passes
    return mean;
}

namespace {

double chi_squared_over_degrees(const Observation& seen, const RowPoint& point, int columns, int rows) {
    const int cells = columns * rows;
    std::vector<double> observed(cells, 0);
    double counted = 0, outside = 0;
    for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
        const rt::vec2 p = point(seen.inputs[k], seen.outputs[k]);
        if (std::isnan(p.x) || std::isnan(p.y)) continue;
        ++counted;
        const int x = int(std::floor(p.x * columns)), y = int(std::floor(p.y * rows));
        // rounding may put a point on the upper rim
        const bool inside = p.x >= -1e-6 && p.y >= -1e-6 && p.x <= 1 + 1e-6 && p.y <= 1 + 1e-6;
        if (inside)
            ++observed[std::clamp(y, 0, rows - 1) * columns + std::clamp(x, 0, columns - 1)];
        else
            ++outside;
    }
    if (counted == 0) return NAN;
    const std::vector<double> expected(cells, counted / cells);
    const ChiSquared result = chi_squared_test(observed, expected);
    return (result.statistic + outside * outside) / std::max(result.degrees, 1);
}

/// The words of the known value that is nearest, and of those that nothing tells apart from it.
std::string nearest_words(const std::vector<KnownValue>& known, double value, double near) {
    const KnownValue* best = nullptr;
    for (const KnownValue& k : known)
        if (std::abs(value - k.value) < near && (!best || std::abs(value - k.value) < std::abs(value - best->value)))
            best = &k;
    if (!best) return {};
    std::vector<std::string> words = {best->words};
    for (const KnownValue& k : known)
        if (std::abs(k.value - best->value) <= near / 4 && std::ranges::count(words, k.words) == 0)
            words.push_back(k.words);
    return fmt::format("{}", fmt::join(words, " Or: "));
}

std::string explained(const std::string& off, const std::string& words, const std::string& else_words) {
    const std::string& after = words.empty() ? else_words : words;
    return after.empty() ? off : off + ": " + after;
}

}  // namespace

Statistic uniform_in_square(const Evenness& e) {
    return {.id = e.id,
            .what = e.what,
            .measure = [point = e.point, columns = e.columns, rows = e.rows](
                           const Observation& seen) { return chi_squared_over_degrees(seen, point, columns, rows); },
            .truth = 1,
            .delta0 = e.delta0,
            .delta = e.delta,
            .hint = e.hint,
            .cause = e.cause,
            .chi_squared = true};
}

Hint always(std::string words) {
    return [words = std::move(words)](double, double) { return words; };
}

Hint with_value(std::string words) {
    return [words = std::move(words)](double value, double) { return fmt::format(fmt::runtime(words), value); };
}

Hint by_value(std::string what, std::vector<KnownValue> known, double near, std::string else_words) {
    return [=](double value, double truth) {
        return explained(fmt::format("{} is {:.3g}, not {:.3g}", what, value, truth), nearest_words(known, value, near),
                         else_words);
    };
}

Hint by_ratio(std::string what, std::vector<KnownValue> known, std::string else_words) {
    return [=](double value, double truth) {
        const double ratio = value / truth;
        return explained(fmt::format("{} is {:.3g} times what it must be", what, ratio),
                         nearest_words(known, ratio, 0.05 * std::abs(ratio) + 0.002), else_words);
    };
}

}  // namespace grade
