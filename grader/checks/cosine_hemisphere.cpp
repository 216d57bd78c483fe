#include "asked/cosine_hemisphere.h"
#include "checks/kit/warp.h"

namespace grade {

namespace {

using rt::DirectionSample;

/// A matt floor under a sky of radiance 1 has its albedo's radiance, whatever direction is drawn: no noise (V1).
Check open_sky(Generator& random) {
    const Place place = any_place(random);
    const double albedo = between(random, 0.3, 0.9);
    const std::string scene = environment(1) +
                              toml(View{place({2, 1, 3}), place({0, 0, 0}), place.axes.z, 30, {24, 24}}) +
                              material("floor", {{"albedo", albedo}}) + place.floor("floor", 50);
    const Statistic light = of_picture(
        {.id = "F1",
         .what = "radiance of the floor, over its albedo",
         .number = [=](const rt::Image& image) { return brightness(region_mean(image, whole(image))) / albedo; },
         .delta = 0.01,
         .hint = by_ratio("the light of a floor under an even sky",
                          {{0.5, "is the density twice too large?"}, {2, "is the density twice too small?"}},
                          "the density is cos(theta)/pi of the direction that is returned")});
    const Statistic noise = of_picture(
        {.id = "V1",
         .what = "largest deviation of a pixel from the albedo",
         .number =
             [=](const rt::Image& image) {
                 double most = 0;
                 for (const rt::Color& c : image.pixels) most = std::max(most, std::abs(c.x / albedo - 1));
                 return most;
             },
         .truth = 0,
         .delta = 2e-3,
         .exact = true,
         .hint = always("directions drawn as the cosine leave no noise under an even sky: is the density that of the "
                        "direction?")});
    return render_check("open_sky", {scene, 4, "random"}, {light, noise});
}

}  // namespace

Checks check_cosine_hemisphere(Generator& random) {
    const auto inputs = with_repeats(rows_of(1024, [](Generator& draw) { return row(square(draw)); }));
    const Statistic above = property({.id = "V3",
                                      .what = "directions below the surface",
                                      .violation = of_call<rt::cosine_hemisphere>(
                                          [](const DirectionSample& s) { return std::max(0.0, -s.direction.z); }),
                                      .tolerance = 1e-6,
                                      .says = "directions with z < 0 leave the hemisphere"});
    const Statistic density =
        right_density<rt::cosine_hemisphere>([](const DirectionSample& s) { return s.direction.z / rt::pi; }, 1e-3,
                                             {{2, "is the hemisphere's density twice too large?"},
                                              {rt::pi, "1/pi is missing: the density is cos(theta)/pi"}});
    const Statistic cosine = mean_of(
        {.id = "V3",
         .what = "mean cosine",
         .number = of_call<rt::cosine_hemisphere>([](const DirectionSample& s) { return s.direction.z; }),
         .truth = 2.0 / 3,
         .hint = by_ratio("the mean cosine",
                          {{0.75, "the directions are uniform on the hemisphere; expected more of them about z"},
                           {1.5, "all directions are the z axis"},
                           {0.5, "are u.x and the height exchanged?"}})});
    const RowPoint cell = of_call<rt::cosine_hemisphere>([](const DirectionSample& s) {
        const auto [x, y, z] = std::tuple(s.direction.x, s.direction.y, s.direction.z);
        return rt::vec2(1 - z * z, turn(x, y));
    });
    const Statistic spread = even_about_z(
        "V3", "chi-squared of directions", cell,
        "the directions are not distributed as cos(theta)/pi: do height and angle each use a number of their own?");
    const auto row_with = [](Generator&, rt::vec2 u) { return row(u); };
    return {probe_check("cosine_law", inputs,
                        {unit_direction<rt::cosine_hemisphere>("V3"), above, cosine, density, spread, purity()}),
            density_of_directions<rt::cosine_hemisphere>({row_with}), ends_of_square(row_with), open_sky(random)};
}

}  // namespace grade
