#include "checks/kit/convergence.h"

#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/kit/probe_check.h"
#include "statistics/closed_forms.h"
#include "statistics/regression.h"

namespace grade {

namespace {

using rt::vec2;

constexpr int count_of_levels = 5, repeats = 12;

using Integrand2d = std::function<double(vec2)>;

/// Errors of the estimates of an integral over the unit square, and their slope; rows are those of error_orders.
double slope_of(const Observation& seen, const SamplesOfASquare& samples, const Integrand2d& f, double integral) {
    std::vector<double> counts, errors;
    std::size_t k = 0;
    for (const int n : levels(count_of_levels)) {
        std::vector<double> off;
        for (int repeat = 0; repeat < repeats; ++repeat) {
            double sum = 0;
            for (int i = 0; i < n; ++i, ++k) {
                const auto sample = samples.sample(seen.inputs[k], seen.outputs[k]);
                sum += sample.weight * f(sample.place) / n;
            }
            off.push_back(sum - integral);
        }
        counts.push_back(n);
        errors.push_back(root_mean_square(off));
    }
    return error_slope(counts, errors);
}

/// Share of the unit square beyond an edge: p . across > beside, p from the middle of the square.
double beyond_edge(vec2 across, double beside) {
    constexpr int columns = 1000;
    double sum = 0;
    for (int k = 0; k < columns; ++k) {
        const double x = (k + 0.5) / columns - 0.5;
        sum += std::clamp(0.5 - (beside - across.x * x) / across.y, 0.0, 1.0) / columns;
    }
    return sum;
}

Statistic order(std::string what, double truth, std::function<double(const Observation&)> measure, Hint hint) {
    return {.id = "G3",
            .what = std::move(what),
            .measure = std::move(measure),
            .truth = truth,
            .delta0 = 0.04,
            .delta = 0.22,
            .hint = std::move(hint)};
}

Hint order_hint(const std::string& what, double due) {
    return [=](double value, double) {
        const std::string off =
            fmt::format("the error {} falls as N^{:.2f} with N samples; expected N^{:.2f}", what, value, due);
        if (value > -0.2) return off + ": it hardly falls at all. Is u used, and does each sample fall elsewhere?";
        if (std::abs(value + 0.5) < 0.12)
            return off + ": the samples are independent, or in strips. Does each fall in a cell of its own?";
        return off;
    };
}

}  // namespace

Check error_orders(Generator& random, const SamplesOfASquare& samples) {
    const double turn = between(random, 0.3, 1.27), beside = between(random, 0.1, 0.35);
    const vec2 across(std::cos(turn), std::sin(turn));
    const auto inputs = [=](Generator& draws) {
        Rows rows;
        for (const int n : levels(count_of_levels))
            for (int repeat = 0; repeat < repeats; ++repeat) {
                const vec2 low(whole_between(draws, 0, 300), whole_between(draws, 0, 300));
                for (int i = 0; i < n; ++i) rows.push_back(samples.arguments(low, i, n, square(draws)));
            }
        return rows;
    };
    const Integrand2d plane = [=](vec2 p) { return rt::dot(p - 0.5, across); };
    const Integrand2d edge = [=](vec2 p) { return rt::dot(p - 0.5, across) > beside ? 1.0 : 0.0; };
    const double covered = beyond_edge(across, beside);
    return probe_check("convergence", inputs,
                       {order(
                            "power of N with which the error of a slope of brightness falls", -1,
                            [=](const Observation& seen) { return slope_of(seen, samples, plane, 0); },
                            order_hint("of a smooth function", -1)),
                        order(
                            "power of N with which the error of an edge falls", -0.75,
                            [=](const Observation& seen) { return slope_of(seen, samples, edge, covered); },
                            order_hint("of an edge", -0.75))});
}

Check rings(Generator& random, const SamplesOfASquare& samples) {
    constexpr int pixels = 96, n = 16;
    // about one ring to a cell: where all cells of a regular grid see the same
    constexpr double fineness = 4, film = 200;  // [1/pixel], [pixel]
    constexpr double rate = fineness * rt::pi / film;
    struct Pixel {
        vec2 low;
        double mean, jagged;  // through a box filter, and what its middle is off by, squared
    };
    std::vector<Pixel> seen_pixels;
    for (int k = 0; k < pixels; ++k) {
        const vec2 low(whole_between(random, 185, 215), whole_between(random, 185, 215));
        const double mean = zone_plate_mean(rate, {low, low + 1.0});
        seen_pixels.push_back({low, mean, rt::sqr(zone_plate(rate, low + 0.5) - mean)});
    }
    const auto inputs = [=](Generator& draws) {
        Rows rows;
        for (const Pixel& pixel : seen_pixels)
            for (int i = 0; i < 2 * n; ++i) rows.push_back(samples.arguments(pixel.low, i % n, n, square(draws)));
        return rows;
    };
    const auto left = [=](const Observation& seen) {
        double bias = 0, jagged = 0;
        std::size_t k = 0;
        for (const Pixel& pixel : seen_pixels) {
            double halves[2] = {0, 0};
            for (int i = 0; i < 2 * n; ++i, ++k) {
                const auto sample = samples.sample(seen.inputs[k], seen.outputs[k]);
                halves[i / n] += sample.weight * zone_plate(rate, pixel.low + sample.place) / n;
            }
            bias += squared_bias(halves[0], halves[1], pixel.mean);
            jagged += pixel.jagged;
        }
        return bias / jagged;
    };
    return probe_check(
        "fine_rings", inputs,
        {{.id = "A2",
          .what = "rings too fine for the pixels: what is left of them in the mean, over what one sample in the middle "
                  "leaves",
          .measure = left,
          .truth = 0,
          .delta0 = 0.02,
          .delta = 0.2,
          .hint = with_value("rings that are too fine for the pixels do not fade: {:.2g} of what one sample in the "
                             "middle leaves of them stays, however many pictures are averaged. Do samples fall "
                             "everywhere in their cells, and the cells on all of the pixel?")}});
}

Statistic error_order(std::string what, int count, int repeated, RowNumber error, double slope, Hint hint) {
    return order(
        std::move(what), slope,
        [=](const Observation& seen) {
            std::vector<double> counts, errors;
            std::size_t k = 0;
            for (const int n : levels(count)) {
                std::vector<double> off;
                for (int repeat = 0; repeat < repeated; ++repeat, ++k)
                    off.push_back(error(seen.inputs[k], seen.outputs[k]));
                counts.push_back(n);
                errors.push_back(root_mean_square(off));
            }
            return error_slope(counts, errors);
        },
        std::move(hint));
}

}  // namespace grade
