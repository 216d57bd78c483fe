#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/shadow_scene.h"
#include "checks/kit/warp.h"

namespace grade {

Checks check_uniform_disk(Generator& random) {
    const auto inputs = [](Generator& draws) {
        return repeat(rows_of(1024, [](Generator& draw) { return row(square(draw)); })(draws));
    };
    const auto square_of_radius = [](const Row&, const Row& out) { return out[0] * out[0] + out[1] * out[1]; };
    Statistic inside = property("D2", "distance beyond the rim",
        [=](const Row& in, const Row& out) { return std::max(0.0, std::sqrt(square_of_radius(in, out)) - 1); }, 1e-6,
        "points fall outside the unit disk");
    Statistic density =
        right_density([](const Row&, const Row&) { return 1 / rt::pi; }, 1e-4,
                      {{rt::pi, "it is 1; expected 1/pi, one over the area"}, {0.5, "it is 1/2 pi; expected 1/pi"}});
    Statistic radius = mean_of("D2", "mean square of the radius", square_of_radius, 0.5, 0.5,
                               by_ratio("the mean square of the radius",
                                        {{2.0 / 3, "r = u.x without its square root crowds the points in the middle"},
                                         {4.0 / 3, "the points fill a square, not a disk"},
                                         {4, "is the radius used as a diameter?"}}));
    const RowPoint cell = [=](const Row& in, const Row& out) {
        return rt::vec2(square_of_radius(in, out), turn(out[0], out[1]));
    };
    Statistic even = uniform_in_square("D2", "chi-squared of equal areas", cell, 8, 8,
                                       always("equal areas of the disk do not get equally many points: do radius and "
                                              "angle each use a number of their own?"));
    name_half_circles(even, cell);
    return {probe_check("even_on_the_disk", inputs, {inside, density, radius, even, purity()}),
            shadow_check(random, "disc_penumbra", any_shadow(random, rt::Emitter::Kind::disc))};
}

}  // namespace grade
