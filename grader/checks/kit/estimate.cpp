#include "checks/kit/estimate.h"

#include <cmath>

#include <fmt/format.h>

#include "statistics/chi_squared.h"
#include "statistics/moments.h"

namespace grade {

Statistic mean_of(std::string id, std::string what, RowNumber number, double truth, double unit, Hint hint) {
    Statistic s;
    s.id = std::move(id);
    s.what = std::move(what);
    s.truth = truth;
    s.delta0 = 0.001 * unit;
    s.delta = 0.05 * unit;
    s.measure = [number](const Observation& seen) {
        Moments mean;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k) mean.add(number(seen.inputs[k], seen.outputs[k]));
        return mean.mean;
    };
    s.hint = std::move(hint);
    return s;
}

void find_half_a_percent(Statistic& mean) {
    mean.delta0 = 0.0005 * *mean.truth;
    mean.delta = 0.0045 * *mean.truth;  // where there is no noise, what is not above it passes
}

Statistic uniform_in_square(std::string id, std::string what, RowPoint point, int columns, int rows, Hint hint) {
    Statistic s;
    s.id = std::move(id);
    s.what = std::move(what);
    s.truth = 1;
    s.delta0 = 0.02;
    s.delta = 0.5;
    s.measure = [point, columns, rows](const Observation& seen) {
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
            if (inside) ++observed[std::clamp(y, 0, rows - 1) * columns + std::clamp(x, 0, columns - 1)];
            else ++outside;
        }
        if (counted == 0) return double(NAN);
        const std::vector<double> expected(cells, counted / cells);
        const ChiSquared result = chi_squared_test(observed, expected);
        return (result.statistic + outside * outside) / std::max(result.degrees, 1);
    };
    s.hint = std::move(hint);
    return s;
}

Hint always(std::string words) {
    return [words = std::move(words)](double, double) { return words; };
}

std::string nearest_words(const std::vector<KnownValue>& known, double value, double near) {
    const KnownValue* best = nullptr;
    for (const KnownValue& k : known)
        if (std::abs(value - k.value) < near && (!best || std::abs(value - k.value) < std::abs(value - best->value)))
            best = &k;
    if (!best) return {};
    std::string words = best->words;
    for (const KnownValue& k : known)
        if (std::abs(k.value - best->value) <= near / 4 && words.find(k.words) == words.npos)
            words += " Or: " + k.words;
    return words;
}

Hint by_ratio(std::string what, std::vector<KnownRatio> known, std::string else_words) {
    return [=](double value, double truth) {
        const double ratio = value / truth;
        const std::string off = fmt::format("{} is {:.3g} times what it must be", what, ratio);
        std::string words = nearest_words(known, ratio, 0.05 * std::abs(ratio) + 0.002);
        if (words.empty()) words = else_words;
        return words.empty() ? off : off + ": " + words;
    };
}

}  // namespace grade
