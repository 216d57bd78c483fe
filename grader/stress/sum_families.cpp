#include "stress/family.h"

namespace grade {

namespace {

using rt::Color;

Integrand constant(double value) { return {Integrand::Kind::polynomial, {value}}; }

/// The integral of 0.1 + x over [0, 1], whose plain sum drifts; the midpoints of any number of intervals give it
/// exactly.
double uniform_count(double x, Generator&, const Asker& ask) {
    return worst_of(ask, "integrate_uniform", {row(Integrand{Integrand::Kind::polynomial, {0.1, 1}}, 0.0, 1.0, int(x))},
                    [](std::size_t, const Row& out) { return std::abs(out.at(0) / 0.6 - 1); });
}

double monte_carlo_count(double x, Generator& random, const Asker& ask) {
    std::vector<double> points(static_cast<std::size_t>(x));
    for (double& point : points) point = between(random, 0, 1);
    return worst_of(ask, "integrate_monte_carlo", {row(constant(0.1), constant(1), points)},
                    [](std::size_t, const Row& out) { return std::abs(out.at(0) / 0.1 - 1); });
}

/// Points with a density of x.
double density_of_points(double x, Generator&, const Asker& ask) {
    const std::vector<double> points{0.1 / x, 0.3 / x, 0.8 / x};
    return worst_of(ask, "integrate_monte_carlo", {row(constant(1), constant(x), points)},
                    [&](std::size_t, const Row& out) { return std::abs(out.at(0) * x - 1); });
}

/// x strata of one number each.
double stratified_count(double x, Generator& random, const Asker& ask) {
    std::vector<StratumOf> strata(static_cast<std::size_t>(x));
    for (std::size_t i = 0; i < strata.size(); ++i) strata[i] = {double(i), double(i + 1), {between(random, 0, 1)}};
    return worst_of(ask, "integrate_stratified", {row(constant(0.1), strata)},
                    [&](std::size_t, const Row& out) { return std::abs(out.at(0) / (0.1 * x) - 1); });
}

/// x samples, of which one channel is dim.
double mean_count(double x, Generator&, const Asker& ask) {
    const auto n = static_cast<std::size_t>(x);
    std::vector<Color> colors(n, Color(0.1, 0.7, 1e-30));
    const std::vector<double> weights(n, 1);
    return worst_of(ask, "pixel_mean", {row(colors, weights)}, [](std::size_t, const Row& out) {
        return worse_error(worse_error(std::abs(out.at(0) / 0.1 - 1), std::abs(out.at(1) / 0.7 - 1)),
                           std::abs(out.at(2) / 1e-30 - 1));
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
        return worst_of(ask, fragment, {in}, [&](std::size_t, const Row& out) { return std::abs(out.at(0) / x - 1); });
    };
}

/// An interval of length x far from 0: the mean place of the points, in the middle.
double narrow_interval(double x, Generator&, const Asker& ask) {
    const double a = 1;
    const Integrand f{Integrand::Kind::polynomial, {0, 1}};
    return worst_of(ask, "integrate_uniform", {row(f, a, a + x, 100)}, [&](std::size_t, const Row& out) {
        const double width = (a + x) - a;
        return std::abs(out.at(0) / (width * (a + width / 2)) - 1);
    });
}

}  // namespace

std::vector<Family> sum_families() {
    constexpr double u = rt::roundoff;
    const std::vector<int> wide = sweep(-60, 60, 3);
    std::vector<Family> all = {
        {"uniform_count",
         {"integrate_uniform"},
         "number of points",
         "relative error",
         1e-5,
         1e-13,
         sweep(0, 7),
         {0, 4},
         uniform_count},
        {"uniform_interval",
         {"integrate_uniform"},
         "length of an interval at 1",
         "relative error",
         1e-5,
         1e-13,
         sweep(-15, 12),
         {-3, 3},
         narrow_interval},
        {"monte_carlo_count",
         {"integrate_monte_carlo"},
         "number of points",
         "relative error",
         1e-5,
         1e-13,
         sweep(0, 6),
         {0, 4},
         monte_carlo_count},
        {"monte_carlo_density",
         {"integrate_monte_carlo"},
         "density of the points",
         "relative error",
         1e-5,
         16 * u,
         wide,
         {-3, 3},
         density_of_points},
        {"stratified_count",
         {"integrate_stratified"},
         "number of strata",
         "relative error",
         1e-5,
         1e-13,
         sweep(0, 6),
         {0, 4},
         stratified_count},
        {"mean_count",
         {"pixel_mean"},
         "number of samples",
         "relative error",
         1e-5,
         1e-13,
         sweep(0, 6),
         {0, 4},
         mean_count},
    };
    for (const std::string fragment :
         {"integrate_uniform", "integrate_monte_carlo", "integrate_stratified", "pixel_mean"})
        all.push_back({"height_" + fragment,
                       {fragment},
                       "height of the integrand",
                       "relative error",
                       1e-5,
                       16 * u,
                       wide,
                       {-3, 3},
                       height(fragment)});
    return all;
}

}  // namespace grade
