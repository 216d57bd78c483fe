#include "statistics/error.h"

#include <algorithm>
#include <cmath>

#include "rt/math.h"

namespace grade {

namespace {

double mean_of(rt::Color c) { return (c.x + c.y + c.z) / 3; }

}  // namespace

SquaredError squared_error(const rt::Image& a, const Halves& halves) {
    rt::Sum plain, relative;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const rt::Color r1 = halves.first.pixels[i], r2 = halves.second.pixels[i], r = 0.5 * (r1 + r2);
        const rt::Color product = (a.pixels[i] - r1) * (a.pixels[i] - r2);
        plain.add(mean_of(product));
        relative.add(mean_of(product / (r * r + 0.01)));
    }
    const double count = double(a.pixels.size());
    return {plain.value() / count, relative.value() / count};
}

Estimate picture_bias(const rt::Image& a1, const rt::Image& a2, const Halves& halves) {
    rt::Sum products, variances, squares;
    for (std::size_t i = 0; i < a1.pixels.size(); ++i) {
        const rt::Color r1 = halves.first.pixels[i], r2 = halves.second.pixels[i];
        const rt::Color a = a1.pixels[i], b = a2.pixels[i];
        products.add(0.5 * mean_of((a - r1) * (b - r2) + (a - r2) * (b - r1)));
        // variances, each from two values; the square of such a one is 3 times too large in the mean
        const rt::Color of_a = 0.5 * (a - b) * (a - b), of_r = 0.5 * (r1 - r2) * (r1 - r2);
        variances.add(mean_of(of_a + of_r));
        squares.add(mean_of((of_a * of_a + of_r * of_r) / 3.0 + 2.0 * of_a * of_r));
    }
    const double count = double(a1.pixels.size()), value = products.value() / count;
    const double variance = (squares.value() + 2 * std::max(value, 0.0) * variances.value()) / count;
    return {value, std::sqrt(variance / count)};
}

double noise_of(const Halves& halves) {
    rt::Sum squares;
    for (std::size_t i = 0; i < halves.first.pixels.size(); ++i) {
        const rt::Color d = halves.first.pixels[i] - halves.second.pixels[i];
        squares.add(mean_of(d * d));
    }
    return std::sqrt(squares.value() / double(halves.first.pixels.size())) / 2;
}

}  // namespace grade
