#include "asked/integrate_monte_carlo.h"
#include "checks/kit/convergence.h"
#include "checks/kit/kit.h"
#include "statistics/regression.h"

namespace grade {

namespace {

using Kind = Integrand::Kind;
using Points = std::vector<double>;

constexpr int random_levels = 5;

/// The mean of f(x_i) Q(x_i)^power. With f = height exp(-rate x), drawn from a density proportional to exp(-rate x) on
/// x > 0, each term of power -1 is height / rate: there is no error at all.
auto estimate_with(double power) {
    return [=](const Integrand& f, const Integrand& q, const Points& x) {
        double sum = 0;
        for (const double xi : x) sum += f(xi) * std::pow(q(xi), power);
        return x.empty() ? 0.0 : sum / double(x.size());
    };
}

/// A wave with a whole number of periods, which regular points do not see, and a sharp peak, from independent points.
Check wave_and_peak(Generator& random) {
    constexpr int count = 24;
    // a span of 1 would not tell the density from its inverse
    const double a = between(random, -1, 1), span = between(random, 1.3, 2), width = 0.02 * span;
    const Integrand density{Kind::polynomial, {1 / span}};
    const Integrand wave{Kind::cosine, {1, 1, count / span, between(random, 0, 6)}};
    const Integrand peak{Kind::gaussian, {1, a + between(random, 0.3, 0.7) * span, width}};
    const auto inputs = rows_of(512, [=](Generator& draw) {
        std::vector<double> x;
        for (int k = 0; k < count; ++k) x.push_back(a + span * between(draw, 0, 1));
        const bool fine = chance(draw, 0.5);
        return row(fine ? wave : peak, density, x);
    });
    // twice the mean over all rows is the mean over those of one kind
    const auto mean_estimate = [=](const std::string& what, const std::string& known_as, Kind kind, double integral) {
        return mean_of({.id = "I1",
                        .what = "mean estimate of " + what + ", over the integral",
                        .number = of_call<rt::integrate_monte_carlo>(
                            [=](double mean, const Integrand& f, const Integrand&, const Points&) {
                                return f.kind == kind ? 2 * mean / integral : 0.0;
                            }),
                        .delta = 0.25,
                        .hint = by_ratio("the mean estimate of " + known_as,
                                         {{double(count), "is the division by the number of points missing?"}},
                                         "expected f(x_i)/Q(x_i), over the number of points")});
    };
    return probe_check("wave_and_peak", inputs,
                       {mean_estimate("a wave that regular points do not see", "a wave", Kind::cosine, span),
                        mean_estimate("a sharp peak", "a sharp peak", Kind::gaussian, width * std::sqrt(2 * rt::pi))});
}

std::vector<double> drawn(Generator& random, int count, double rate) {
    std::vector<double> x;
    for (int k = 0; k < count; ++k) x.push_back(std::exponential_distribution<double>(rate)(random));
    return x;
}

Statistic given_estimate() {
    return formula<rt::integrate_monte_carlo>(
        {.id = "I1",
         .what = "estimate from given points, off by",
         .tolerance = 1e-4,
         .right = estimate_with(-1),
         .suspects = {{"f is multiplied by the density; expected the weight 1/Q", estimate_with(1)},
                      {"the density is ignored; expected the weight 1/Q(x_i)", estimate_with(0)},
                      {"one density serves all points; expected that of each, w_i = 1/Q(x_i)",
                       [](const Integrand& f, const Integrand& q, const Points& x) {
                           double sum = 0;
                           for (const double xi : x) sum += f(xi) / q(x[0]) / double(x.size());
                           return sum;
                       }},
                      {"the sum is not divided by the number of points",
                       [](double right, const Integrand&, const Integrand&, const Points& x) {
                           return right * double(x.size());
                       }},
                      {"points where f is 0 are not counted; expected the mean over all N points",
                       [](double right, const Integrand& f, const Integrand&, const Points& x) {
                           const auto found = std::ranges::count_if(x, [&](double xi) { return f(xi) != 0; });
                           return found == 0 ? right : right * double(x.size()) / double(found);
                       }}}});
}

}  // namespace

Checks check_integrate_monte_carlo(Generator& random) {
    const auto inputs = [](Generator& draw) {
        Rows rows;
        for (int k = 0; k < 48; ++k) {
            const double rate = between(draw, 0.5, 2), other = k % 2 ? rate : between(draw, 0.5, 2) * rate;
            const double height = (k % 3 == 1 ? -1 : 1) * between(draw, 1, 3);
            const Integrand q{Kind::exponential, {other, other}};
            // where f is 0, a point counts as any other
            const Integrand f = k % 6 == 5 ? Integrand{Kind::step, {0.7 / rate, 0, height}}
                                           : Integrand{Kind::exponential, {height, rate}};
            rows.push_back(row(f, q, drawn(draw, k == 0 ? 0 : whole_between(draw, 2, 40), other)));
        }
        return rows;
    };

    // Over many draws the mean is the integral: height / rate.
    const double rate = between(random, 0.8, 1.2), other = between(random, 0.75, 1.2) * rate;
    const auto repeated = rows_of(256, [=](Generator& draw) {
        const Integrand f{Kind::exponential, {2, rate}}, q{Kind::exponential, {other, other}};
        return row(f, q, drawn(draw, 32, other));
    });
    const Statistic mean =
        mean_of({.id = "I1",
                 .what = "mean estimate over the integral",
                 .number = of_call<rt::integrate_monte_carlo>([=](double mean) { return mean * rate / 2; }),
                 .hint = by_ratio("the mean estimate", {{32, "is the division by the number of points missing?"}})});

    constexpr int repeats = 16;
    const double slower = 0.8 * rate;  // of the density: its fourth moments are finite
    const auto more_points = [=](Generator& draw) {
        Rows rows;
        for (const int n : levels(random_levels))
            for (int k = 0; k < repeats; ++k) {
                const Integrand f{Kind::exponential, {2, rate}}, q{Kind::exponential, {slower, slower}};
                rows.push_back(row(f, q, drawn(draw, n, slower)));
            }
        return rows;
    };
    const Statistic order =
        error_order("power of N with which the error falls", random_levels, repeats,
                    of_call<rt::integrate_monte_carlo>([=](double mean) { return mean - 2 / rate; }), -0.5,
                    with_value("the error falls as N^{:.2f} with N points; expected N^-0.5: is the sum divided by N, "
                               "with the weight 1/Q(x_i) of each point?"));
    return {probe_check("given_points", inputs, {given_estimate()}), probe_check("unbiased", repeated, {mean}),
            wave_and_peak(random), probe_check("convergence", more_points, {order})};
}

}  // namespace grade
