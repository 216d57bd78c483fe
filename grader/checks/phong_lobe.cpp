#include "asked/phong_lobe.h"
#include "checks/kit/warp.h"
#include "statistics/closed_forms.h"
#include "statistics/moments.h"

namespace grade {

namespace {

using rt::DirectionSample;

/// N Var/mean^2 of a lobe that is seen head on, of the BRDF (n + 2)/2pi cos^n times the cosine, over the density.
Statistic noise_of_lobe(double n) {
    return {.id = "V1",
            .what = "variance of a lobe seen head on, N Var/mean^2 over 1/((n + 1)(n + 3))",
            .measure =
                [n](const Observation& seen) {
                    Moments estimate;
                    for (const Row& out : seen.outputs) {
                        const auto [d, density] = result<rt::phong_lobe>(out);
                        estimate.add((n + 2) / (2 * rt::pi) * std::pow(std::max(0.0, d.z), n + 1) / density);
                    }
                    return estimate.m2 / estimate.count / rt::sqr(estimate.mean) / lobe_dispersion(n);
                },
            .truth = 1,
            .delta0 = 0.001,
            .delta = 0.3,
            .hint = by_ratio("the variance of a lobe seen head on", {{0, "are all directions one?"}},
                             "are directions drawn from the density that is returned?")};
}

Check lobe(const std::string& name, double n) {
    const Statistic density = right_density<rt::phong_lobe>(
        [n](const DirectionSample& s) { return (n + 1) / (2 * rt::pi) * std::pow(std::max(0.0, s.direction.z), n); },
        0.01,
        {{(n + 2) / (n + 1), "n + 2 belongs to the BRDF; the density has n + 1"},
         {n / (n + 1), "n + 1 is n"},
         {2, "2 pi is pi"},
         {2 * rt::pi, "1/2pi is missing"}});
    // -log cos(alpha) is exponentially distributed with mean 1/(n + 1)
    const Statistic width =
        mean_of({.id = "P1",
                 .what = "(n + 1) mean of -log cos(alpha)",
                 .number = of_call<rt::phong_lobe>(
                     [n](const DirectionSample& s) { return -(n + 1) * std::log(std::max(s.direction.z, 1e-30)); }),
                 .hint = by_ratio("the lobe's width",
                                  {{(n + 1) / n, "the exponent is n - 1: cos(alpha) = u^(1/(n+1))"},
                                   {(n + 1) / (n + 2), "the exponent is n + 1: cos(alpha) = u^(1/(n+1))"},
                                   {(n + 1) / (2 * n + 1), "the exponent is 2 n"},
                                   {0, "all directions are the z axis"}},
                                  "the exponent is wrong: cos(alpha) = u^(1/(n+1))")});
    const RowPoint cell = of_call<rt::phong_lobe>([n](const DirectionSample& s) {
        return rt::vec2(std::pow(std::max(0.0, s.direction.z), n + 1), turn(s.direction.x, s.direction.y));
    });
    const Statistic spread = even_about_z("P1", "chi-squared of directions", cell,
                                          "the directions are not distributed as (n + 1)/(2 pi) cos(alpha)^n: do "
                                          "height and angle each use a number of their own?");
    return probe_check(name, with_repeats(rows_of(1024, [n](Generator& draw) { return row(n, square(draw)); })),
                       {unit_direction<rt::phong_lobe>("V3"), width, density, spread, noise_of_lobe(n), purity()});
}

/// Exponents from 0 to 10,000: the density of each direction, and the lobe's width.
Check any_exponent() {
    const auto inputs = [](Generator& random) {
        Rows rows = rows_of_decades(0, 4, 128, [](Generator& draw, double n) { return row(n, square(draw)); })(random);
        for (int k = 0; k < 128; ++k)
            rows.push_back(row(chance(random, 0.2) ? 0 : between(random, 0, 1), square(random)));
        // along the surface, where a density is 0 but for an exponent of 0
        for (int k = 0; k < 8; ++k)
            for (const double n : {0.0, between(random, 0.5, 1), log_between(random, 1, 1e4)})
                rows.push_back(row(n, rt::vec2(0, between(random, 0, 1))));
        return rows;
    };
    return probe_check(
        "any_exponent", inputs,
        {property({.id = "V3",
                   .what = "returned density over that of the returned direction, off 1 by",
                   .violation = of_call<rt::phong_lobe>([](const DirectionSample& s, double n, rt::vec2) {
                       const double right = (n + 1) / (2 * rt::pi) * std::pow(std::max(0.0, s.direction.z), n);
                       return std::abs(s.density - right) / (right + 1e-6);
                   }),
                   .tolerance = 0.02,
                   .says = "the density is not (n + 1)/(2 pi) cos(alpha)^n of the returned direction, for some "
                           "exponent from 0 to 10,000"}),
         mean_of({.id = "P1",
                  .what = "(n + 1) mean of -log cos(alpha), for exponents from 0 to 10,000",
                  .number = of_call<rt::phong_lobe>([](const DirectionSample& s, double n, rt::vec2 u) {
                      return u.x > 0 ? -(n + 1) * std::log(std::max(s.direction.z, 1e-30)) : 1;
                  }),
                  .delta0 = 0.01,
                  .delta = 0.2,
                  .hint = always("lobes of some exponents from 0 to 10,000 are too wide or too narrow")})});
}

}  // namespace

Checks check_phong_lobe(Generator& random) {
    const double narrow = between(random, 20, 60), wide = between(random, 2, 6);
    const auto row_with = [](Generator& draw, rt::vec2 u) { return row(log_between(draw, 1, 1e4), u); };
    return {lobe("narrow_lobe", narrow), lobe("wide_lobe", wide), any_exponent(),
            density_of_directions<rt::phong_lobe>(
                {[](Generator& draw, rt::vec2 u) { return row(log_between(draw, 1, 30), u); },
                 [](Generator& draw, rt::vec2 u) { return row(between(draw, 0, 1), u); }}),
            ends_of_square(row_with)};
}

}  // namespace grade
