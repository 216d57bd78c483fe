#include <fmt/format.h>

#include "checks/fragment_checks.h"
#include "checks/kit/draw.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/render_check.h"
#include "checks/kit/warp.h"

namespace grade {

namespace {

/// A matt floor under a sky of radiance 1 has its albedo's radiance, whatever direction is drawn: no noise (V1).
Check open_sky(Generator& random) {
    const Place place = any_place(random);
    const double albedo = between(random, 0.3, 0.9);
    const std::string scene = "environment = 1\n\n" +
                              toml(View{place({2, 1, 3}), place({0, 0, 0}), place.axes.z, 30, {24, 24}}) +
                              fmt::format("[materials.floor]\nalbedo = {}\n\n", toml(albedo)) +
                              quad("floor", place({0, 0, 0}), 50.0 * place.axes.x, 50.0 * place.axes.y);
    Statistic light = of_picture(
        "F1", "radiance of the floor, over its albedo",
        [=](const rt::Image& image) { return brightness(region_mean(image, whole(image))) / albedo; }, 1, 0.01,
        by_ratio("the light of a floor under an even sky",
                 {{0.5, "is the density twice too large?"}, {2, "is the density twice too small?"}},
                 "the density is cos(theta)/pi of the direction that is returned"));
    Statistic noise = of_picture(
        "V1", "largest deviation of a pixel from the albedo",
        [=](const rt::Image& image) {
            double most = 0;
            for (const rt::Color& c : image.pixels) most = std::max(most, std::abs(c.x / albedo - 1));
            return most;
        },
        0, 2e-3,
        always(
            "directions drawn as the cosine leave no noise under an even sky: is the density that of the direction?"));
    noise.exact = true;
    return render_check("open_sky", {scene, 4, "random"}, {light, noise});
}

}  // namespace

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
