#include "checks/draw.h"
#include "checks/estimate.h"
#include "checks/formula.h"
#include "checks/fragment_checks.h"
#include "checks/probe_check.h"

namespace grade {

namespace {

using Kind = Integrand::Kind;

/// f = height exp(-rate x), drawn from a density proportional to exp(-other x) on x > 0: each term of the sum is known,
///
///     height / other exp((other - rate) x)
///
/// so the estimate is; with other = rate there is no error at all. power is that of the density.
RowFunction estimate(double power, bool mean) {
    return of<Integrand, Integrand, std::vector<double>>([=](const Integrand& f, const Integrand& q, const std::vector<double>& x) {
        double sum = 0;
        for (const double xi : x)
            sum += f.parameters[0] * std::pow(q.parameters[0], power) * std::exp(-(f.parameters[1] + power * q.parameters[1]) * xi);
        return Row{x.empty() ? 0.0 : mean ? sum / double(x.size()) : sum};
    });
}

std::vector<double> drawn(Generator& random, int count, double rate) {
    std::vector<double> x;
    for (int k = 0; k < count; ++k) x.push_back(std::exponential_distribution<double>(rate)(random));
    return x;
}

}  // namespace

Checks check_integrate_monte_carlo(Generator& random) {
    const auto inputs = [](Generator& draw) {
        Rows rows;
        for (int k = 0; k < 48; ++k) {
            const double rate = between(draw, 0.5, 2), other = k % 2 ? rate : between(draw, 0.5, 2) * rate;
            const Integrand f{Kind::exponential, {between(draw, 1, 3), rate}}, q{Kind::exponential, {other, other}};
            rows.push_back(row(f, q, drawn(draw, k == 0 ? 0 : whole_between(draw, 2, 40), other)));
        }
        return rows;
    };
    Statistic value = formula("I1", "estimate from given points, off by", estimate(-1, true), 1e-4,
                              {{"f is multiplied by the density; expected the weight 1/Q", estimate(1, true)},
                               {"the density is ignored; expected the weight 1/Q(x_i)", estimate(0, true)},
                               {"one density serves all points; expected that of each, w_i = 1/Q(x_i)",
                               of<Integrand, Integrand, std::vector<double>>([](const Integrand& f, const Integrand& q, const std::vector<double>& x) {
                                   double sum = 0;
                                   for (const double xi : x) sum += f(xi) / q(x[0]) / double(x.size());
                                   return sum;
                               })},
                               {"the sum is not divided by the number of points", estimate(-1, false)}});

    // Over many draws the mean is the integral: height / rate.
    const double rate = between(random, 0.8, 1.2), other = between(random, 0.75, 1.2) * rate;
    const auto repeated = rows_of(256, [=](Generator& draw) {
        const Integrand f{Kind::exponential, {2, rate}}, q{Kind::exponential, {other, other}};
        return row(f, q, drawn(draw, 32, other));
    });
    Statistic mean = mean_of("I1", "mean estimate over the integral", [=](const Row&, const Row& out) { return out[0] * rate / 2; }, 1, 1,
                             by_ratio("the mean estimate", {{32, "is the division by the number of points missing?"}}));
    return {probe_check("given_points", "integrate_monte_carlo", {}, inputs, {value}),
            probe_check("unbiased", "integrate_monte_carlo", {}, repeated, {mean})};
}

}  // namespace grade
