#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/warp.h"
#include "statistics/lobe.h"
#include "statistics/moments.h"

namespace grade {

Checks check_phong_lobe(Generator& random) {
    Checks checks;
    for (const char* name : {"narrow_lobe", "wide_lobe"}) {
        const double n = checks.empty() ? between(random, 20, 60) : between(random, 2, 6);
        const auto inputs = [n](Generator& draws) {
            return repeat(rows_of(1024, [n](Generator& draw) { return row(n, square(draw)); })(draws));
        };
        Statistic density = right_density(
            [n](const Row&, const Row& out) { return (n + 1) / (2 * rt::pi) * std::pow(std::max(0.0, out[2]), n); },
            0.01,
            {{(n + 2) / (n + 1), "n + 2 belongs to the BRDF; the density has n + 1"},
             {n / (n + 1), "n + 1 is n"},
             {2, "2 pi is pi"},
             {2 * rt::pi, "1/2pi is missing"}});
        // -log cos(alpha) is exponentially distributed with mean 1/(n + 1)
        Statistic width = mean_of("P1", "(n + 1) mean of -log cos(alpha)",
            [n](const Row&, const Row& out) { return -(n + 1) * std::log(std::max(out[2], 1e-30)); }, 1, 1,
            by_ratio("the lobe's width", {{(n + 1) / n, "the exponent is n - 1: cos(alpha) = u^(1/(n+1))"},
                                          {(n + 1) / (n + 2), "the exponent is n + 1: cos(alpha) = u^(1/(n+1))"},
                                          {(n + 1) / (2 * n + 1), "the exponent is 2 n"},
                                          {0, "all directions are the z axis"}},
                     "the exponent is wrong: cos(alpha) = u^(1/(n+1))"));
        const RowPoint cell = [n](const Row&, const Row& out) {
            return rt::vec2(std::pow(std::max(0.0, out[2]), n + 1), turn(out[0], out[1]));
        };
        Statistic spread =
            uniform_in_square("P1", "chi-squared of directions", cell, 8, 8,
                              always("the directions are not distributed as (n + 1)/(2 pi) cos(alpha)^n: do height and "
                                     "angle each use a number of their own?"));
        name_half_circles(spread, cell);
        // of the BRDF (n + 2)/2pi cos^n times the cosine, over the density
        Statistic noise =
            mean_of("V1", "noise of a lobe seen head on, N Var/mean^2 over 1/((n + 1)(n + 3))", nullptr, 1, 1,
                    by_ratio("the noise of a lobe seen head on", {{0, "are all directions one?"}},
                             "are directions drawn from the density that is returned?"));
        noise.measure = [n](const Observation& seen) {
            Moments estimate;
            for (const Row& out : seen.outputs)
                estimate.add((n + 2) / (2 * rt::pi) * std::pow(std::max(0.0, out[2]), n + 1) / out[3]);
            return estimate.m2 / estimate.count / rt::sqr(estimate.mean) / lobe_dispersion(n);
        };
        noise.delta = 0.3;
        checks.push_back(probe_check(name, inputs, {unit_length(), width, density, spread, noise, purity()}));
    }
    return checks;
}

}  // namespace grade
