#include "asked/sphere_cone.h"
#include "checks/kit/shadow_scene.h"
#include "checks/kit/warp.h"

namespace grade {

namespace {

using rt::DirectionSample;

Check cone(const std::string& name, double sine) {
    const double cap = 1 - std::sqrt(1 - sine * sine);  // over 2 pi, the solid angle
    const auto share_of_height = [cap](const DirectionSample& s) { return (1 - s.direction.z) / cap; };
    const Statistic inside = property({.id = "V3",
                                       .what = "cosine outside the cone, over that of its rim",
                                       .violation = of_call<rt::sphere_cone>([=](const DirectionSample& s) {
                                           return std::max(0.0, share_of_height(s) - 1);
                                       }),
                                       .tolerance = 1e-3,
                                       .says = "directions lie outside the cone: sine is that of the angle between "
                                               "axis and rim"});
    const double wide = 1 - std::sqrt(std::max(0.0, 1 - 4 * sine * sine));
    const Statistic density = right_density<rt::sphere_cone>(
        [cap](const DirectionSample&) { return 1 / (2 * rt::pi * cap); }, 1e-3,
        {{2 * cap / (sine * sine), "1/(pi sine^2) is that of a flat disc; the cap has 1/(2 pi (1 - cos))"},
         {2, "2 pi is pi"},
         {2 * cap, "this is the density of the whole sphere"},
         {cap, "this is the density of the hemisphere"},
         {cap / std::max(wide, 1e-9), "the cone has twice its angle"}});
    const Statistic height =
        mean_of({.id = "V3",
                 .what = "mean of (1 - cos(theta)) over its greatest value",
                 .number = of_call<rt::sphere_cone>(share_of_height),
                 .truth = 0.5,
                 .hint = by_ratio("the mean of 1 - cos(theta)",
                                  {{2.0 / 3, "the angle itself is uniform in u.x; expected its cosine"},
                                   {0, "all directions are the z axis"}})});
    const RowPoint cell = of_call<rt::sphere_cone>(
        [=](const DirectionSample& s) { return rt::vec2(share_of_height(s), turn(s.direction.x, s.direction.y)); });
    const Statistic spread = even_about_z("V3", "chi-squared of directions", cell,
                                          "equal parts of the cone do not get equally many directions: do height and "
                                          "angle each use a number of their own?");
    return probe_check(name, with_repeats(rows_of(1024, [sine](Generator& draw) { return row(sine, square(draw)); })),
                       {unit_direction<rt::sphere_cone>("V3"), inside, height, density, spread, purity()});
}

}  // namespace

Checks check_sphere_cone(Generator& random) {
    const double small = between(random, 0.05, 0.15), large = between(random, 0.6, 0.95);
    const auto row_with = [](Generator& draw, rt::vec2 u) {
        return row(chance(draw, 0.1) ? 1 : log_between(draw, 1e-3, 1), u);
    };
    Check ends = ends_of_square(row_with);
    ends.statistics.push_back(
        property({.id = "V3",
                  .what = "density for any sine from 0.001 to 1, off by its share",
                  .violation = of_call<rt::sphere_cone>([](const DirectionSample& s, double sine, rt::vec2) {
                      const double m = sine * sine / (1 + std::sqrt(1 - sine * sine));
                      return std::abs(s.density * 2 * rt::pi * m - 1);
                  }),
                  .tolerance = 1e-3,
                  .says = "the density is wrong for a very small sphere, or for one that fills half of the sky"}));
    return {cone("small_sphere", small), cone("large_sphere", large),
            density_of_directions<rt::sphere_cone>({[](Generator& draw, rt::vec2 u) {
                return row(chance(draw, 0.15) ? 1 : log_between(draw, 0.02, 0.99), u);
            }}),
            ends, shadow_check(random, "sphere_penumbra", any_shadow(random, rt::Emitter::Kind::sphere))};
}

}  // namespace grade
