#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/shadow_scene.h"
#include "checks/kit/warp.h"

namespace grade {

Checks check_sphere_cone(Generator& random) {
    Checks checks;
    for (const char* name : {"small_sphere", "large_sphere"}) {
        const double sine = checks.empty() ? between(random, 0.05, 0.15) : between(random, 0.6, 0.95);
        const double cap = 1 - std::sqrt(1 - sine * sine);  // over 2 pi, the solid angle
        const auto inputs = [sine](Generator& draws) {
            return repeat(rows_of(1024, [sine](Generator& draw) { return row(sine, square(draw)); })(draws));
        };
        Statistic inside = property("V3", "cosine outside the cone, over that of its rim",
            [cap](const Row&, const Row& out) { return std::max(0.0, (1 - out[2]) / cap - 1); }, 1e-3,
            "directions lie outside the cone: sine is that of the angle between axis and rim");
        const double wide = 1 - std::sqrt(std::max(0.0, 1 - 4 * sine * sine));
        Statistic density = right_density(
            [cap](const Row&, const Row&) { return 1 / (2 * rt::pi * cap); }, 1e-3,
            {{2 * cap / (sine * sine), "1/(pi sine^2) is that of a flat disc; the cap has 1/(2 pi (1 - cos))"},
             {2, "2 pi is pi"},
             {2 * cap, "this is the density of the whole sphere"},
             {cap, "this is the density of the hemisphere"},
             {cap / std::max(wide, 1e-9), "the cone has twice its angle"}});
        Statistic height = mean_of(
            "V3", "mean of (1 - cos(theta)) over its greatest value",
            [cap](const Row&, const Row& out) { return (1 - out[2]) / cap; }, 0.5, 0.5,
            by_ratio("the mean of 1 - cos(theta)",
                     {{2.0 / 3, "the angle itself is uniform in u.x; expected its cosine"},
                      {0, "all directions are the z axis"}}));
        const RowPoint cell = [cap](const Row&, const Row& out) {
            return rt::vec2((1 - out[2]) / cap, turn(out[0], out[1]));
        };
        Statistic spread = uniform_in_square("V3", "chi-squared of directions", cell, 8, 8,
                                             always("equal parts of the cone do not get equally many directions: do "
                                                    "height and angle each use a number of their own?"));
        name_half_circles(spread, cell);
        checks.push_back(probe_check(name, inputs, {unit_length(), inside, height, density, spread, purity()}));
    }
    checks.push_back(shadow_check(random, "sphere_penumbra", any_shadow(random, rt::Emitter::Kind::sphere)));
    return checks;
}

}  // namespace grade
