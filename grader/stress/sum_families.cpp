#include "asked/integrate_monte_carlo.h"
#include "asked/pixel_mean.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::Color;

Integrand constant(double value) { return {Integrand::Kind::polynomial, {value}}; }

/// Of the first number of one call.
double relative_error(const Asker& ask, const std::string& fragment, const Row& inputs, double truth) {
    return worst_of_rows(ask, fragment, {inputs},
                         [=](std::size_t, const Row& out) { return std::abs(out.at(0) / truth - 1); });
}

/// The integral of 0.1 + x over [0, 1], whose plain sum drifts; the midpoints of any number of intervals give it
/// exactly.
double uniform_count(double x, Generator&, const Asker& ask) {
    return relative_error(ask, "integrate_uniform",
                          row(Integrand{Integrand::Kind::polynomial, {0.1, 1}}, 0.0, 1.0, int(x)), 0.6);
}

double monte_carlo_count(double x, Generator& random, const Asker& ask) {
    std::vector<double> points(static_cast<std::size_t>(x));
    for (double& point : points) point = between(random, 0, 1);
    return relative_error(ask, "integrate_monte_carlo", row(constant(0.1), constant(1), points), 0.1);
}

/// Points with a density of x.
double density_of_points(double x, Generator&, const Asker& ask) {
    const std::vector<double> points{0.1 / x, 0.3 / x, 0.8 / x};
    return worst_of<rt::integrate_monte_carlo>(ask, "integrate_monte_carlo", {row(constant(1), constant(x), points)},
                                               [=](double got) { return std::abs(got * x - 1); });
}

/// x strata of one number each.
double stratified_count(double x, Generator& random, const Asker& ask) {
    std::vector<StratumOf> strata(static_cast<std::size_t>(x));
    for (std::size_t i = 0; i < strata.size(); ++i) strata[i] = {double(i), double(i + 1), {between(random, 0, 1)}};
    return relative_error(ask, "integrate_stratified", row(constant(0.1), strata), 0.1 * x);
}

/// x samples, of which one channel is dim.
double mean_count(double x, Generator&, const Asker& ask) {
    const auto n = static_cast<std::size_t>(x);
    std::vector<Color> colors(n, Color(0.1, 0.7, 1e-30));
    const std::vector<double> weights(n, 1);
    return worst_of<rt::pixel_mean>(ask, "pixel_mean", {row(colors, weights)}, [](Color got) {
        return worse_error(worse_error(std::abs(got.x / 0.1 - 1), std::abs(got.y / 0.7 - 1)),
                           std::abs(got.z / 1e-30 - 1));
    });
}

/// Integrand and samples x times as large.
auto height(const std::string& fragment) {
    return [=](double x, Generator&, const Asker& ask) {
        const std::vector<double> points{0.1, 0.3, 0.8};
        Row in;
        if (fragment == "integrate_uniform") in = row(constant(x), 0.0, 1.0, 10);
        if (fragment == "integrate_monte_carlo") in = row(constant(x), constant(1), points);
        if (fragment == "integrate_stratified")
            in = row(constant(x), std::vector<StratumOf>{{0, 0.5, points}, {0.5, 1, points}});
        if (fragment == "pixel_mean") in = row(std::vector<Color>(5, Color(x)), std::vector<double>(5, 1));
        return relative_error(ask, fragment, in, x);
    };
}

/// An interval of length x far from 0: the mean place of the points, in the middle.
double narrow_interval(double x, Generator&, const Asker& ask) {
    const double a = 1;
    const Integrand f{Integrand::Kind::polynomial, {0, 1}};
    const double width = (a + x) - a;
    return relative_error(ask, "integrate_uniform", row(f, a, a + x, 100), width * (a + width / 2));
}

}  // namespace

std::vector<Family> sum_families() {
    constexpr double u = rt::roundoff;
    const std::vector<int> wide = sweep(-60, 60, 3);
    std::vector<Family> all = {
        Family("uniform_count", {"integrate_uniform"}, "number of points", "relative error",
               {.bound = 1e-13, .decades = sweep(0, 7), .scored = {0, 4}}, uniform_count),
        Family("uniform_interval", {"integrate_uniform"}, "length of an interval at 1", "relative error",
               {.bound = 1e-13, .decades = sweep(-15, 12)}, narrow_interval),
        Family("monte_carlo_count", {"integrate_monte_carlo"}, "number of points", "relative error",
               {.bound = 1e-13, .decades = sweep(0, 6), .scored = {0, 4}}, monte_carlo_count),
        Family("monte_carlo_density", {"integrate_monte_carlo"}, "density of the points", "relative error",
               {.bound = 16 * u, .decades = wide}, density_of_points),
        Family("stratified_count", {"integrate_stratified"}, "number of strata", "relative error",
               {.bound = 1e-13, .decades = sweep(0, 6), .scored = {0, 4}}, stratified_count),
        Family("mean_count", {"pixel_mean"}, "number of samples", "relative error",
               {.bound = 1e-13, .decades = sweep(0, 6), .scored = {0, 4}}, mean_count)};
    for (const std::string fragment :
         {"integrate_uniform", "integrate_monte_carlo", "integrate_stratified", "pixel_mean"})
        all.push_back(Family("height_" + fragment, {fragment}, "height of the integrand", "relative error",
                             {.bound = 16 * u, .decades = wide}, height(fragment)));
    return all;
}

}  // namespace grade::stress
