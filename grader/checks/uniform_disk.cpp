#include "asked/uniform_disk.h"
#include "checks/kit/shadow_scene.h"
#include "checks/kit/warp.h"

namespace grade {

Checks check_uniform_disk(Generator& random) {
    using rt::DiskSample;
    const auto inputs = with_repeats(rows_of(1024, [](Generator& draw) { return row(square(draw)); }));
    const auto square_of_radius = [](const DiskSample& s) { return s.point.x * s.point.x + s.point.y * s.point.y; };
    const Statistic inside = property({.id = "D2",
                                       .what = "distance beyond the rim",
                                       .violation = of_call<rt::uniform_disk>([=](const DiskSample& s) {
                                           return std::max(0.0, std::sqrt(square_of_radius(s)) - 1);
                                       }),
                                       .tolerance = 1e-6,
                                       .says = "points fall outside the unit disk"});
    const Statistic density = right_density<rt::uniform_disk>(
        [](const DiskSample&) { return 1 / rt::pi; }, 1e-4,
        {{rt::pi, "it is 1; expected 1/pi, one over the area"}, {0.5, "it is 1/2 pi; expected 1/pi"}});
    const Statistic radius =
        mean_of({.id = "D2",
                 .what = "mean square of the radius",
                 .number = of_call<rt::uniform_disk>(square_of_radius),
                 .truth = 0.5,
                 .hint = by_ratio("the mean square of the radius",
                                  {{2.0 / 3, "r = u.x without its square root crowds the points in the middle"},
                                   {4.0 / 3, "the points fill a square, not a disk"},
                                   {4, "is the radius used as a diameter?"}})});
    const RowPoint cell = of_call<rt::uniform_disk>(
        [=](const DiskSample& s) { return rt::vec2(square_of_radius(s), turn(s.point.x, s.point.y)); });
    const Statistic even = even_about_z(
        "D2", "chi-squared of equal areas", cell,
        "equal areas of the disk do not get equally many points: do radius and angle each use a number of their own?");
    const auto row_with = [](Generator&, rt::vec2 u) { return row(u); };
    return {probe_check("even_on_the_disk", inputs, {inside, density, radius, even, purity()}),
            density_of_warp({row_with},
                            {of_call<rt::uniform_disk>([](const DiskSample& s) { return rt::vec3(s.point, 0); }),
                             of_call<rt::uniform_disk>([](const DiskSample&) { return 1 / rt::pi; }), "1/pi"}),
            ends_of_square(row_with),
            shadow_check(random, "disc_penumbra", any_shadow(random, rt::Emitter::Kind::disc))};
}

}  // namespace grade
