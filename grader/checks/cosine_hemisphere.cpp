#include "checks/kit/figures.h"
#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/warp.h"

namespace grade {

Checks check_cosine_hemisphere(Generator& random) {
    const auto inputs = [](Generator& draws) {
        return repeat(rows_of(1024, [](Generator& draw) { return row(square(draw)); })(draws));
    };
    Statistic above = property(
        "V3", "directions below the surface", [](const Row&, const Row& out) { return std::max(0.0, -out[2]); }, 1e-6,
        "directions with z < 0 leave the hemisphere");
    Statistic density = right_density([](const Row&, const Row& out) { return out[2] / rt::pi; }, 1e-3,
                                      {{2, "is the hemisphere's density twice too large?"},
                                       {rt::pi, "1/pi is missing: the density is cos(theta)/pi"}});
    Statistic cosine = mean_of(
        "V3", "mean cosine", [](const Row&, const Row& out) { return out[2]; }, 2.0 / 3, 2.0 / 3,
        by_ratio("the mean cosine",
                 {{0.75, "the directions are uniform on the hemisphere; expected more of them about z"},
                  {1.5, "all directions are the z axis"},
                  {0.5, "are u.x and the height exchanged?"}}));
    const RowPoint cell = [](const Row&, const Row& out) {
        return rt::vec2(1 - out[2] * out[2], turn(out[0], out[1]));
    };
    Statistic spread = uniform_in_square("V3", "chi-squared of directions", cell, 8, 8,
                                         always("the directions are not distributed as cos(theta)/pi: do height and "
                                                "angle each use a number of their own?"));
    name_half_circles(spread, cell);
    return {probe_check("cosine_law", inputs, {unit_length(), above, cosine, density, spread, purity()}),
            open_sky(random)};
}

}  // namespace grade
