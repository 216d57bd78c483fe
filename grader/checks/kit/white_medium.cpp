#include "checks/kit/white_medium.h"

#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/kit/render_check.h"
#include "statistics/closed_forms.h"
#include "statistics/region.h"

namespace grade {

std::string milk(const std::string& name, double extinction, rt::vec3 albedo, double g) {
    const std::string medium = fmt::format("{{ extinction = {}, albedo = {}, g = {} }}", SceneValue(extinction).text,
                                           SceneValue(albedo).text, SceneValue(g).text);
    return material(name, {{"transmittance", 1}, {"medium", medium.c_str()}});
}

Check white_medium(Generator& random) {
    const Place place = any_place(random);
    const double g = (chance(random, 0.5) ? 1 : -1) * between(random, 0.3, 0.5), extinction = between(random, 1, 1.6);
    const double around = log_between(random, 0.3, 3);
    constexpr double loss = 0.03, far = 60;
    const std::string scene = environment(around) + toml(place.from_above(far, vfov_of(1.1, far), {16, 16})) +
                              milk("milk", extinction, {1, 1 - loss, 1 - 2 * loss}, g) +
                              sphere("milk", place({0, 0, 0}), 1);
    const Statistic red = of_picture(
        {.id = "B1",
         .what = "radiance of a white medium, over that of its surroundings",
         .number =
             [=](const rt::Image& image) {
                 return region_mean(image, {4, 4, 8, 8}).r / around;
             },
         .delta = 0.05,
         .hint = with_value(
             "a white medium where light comes from everywhere alike must be invisible, but its radiance is {:.3g} "
             "times that of its surroundings: is the density normalised, and that of the direction?")});
    // the ball takes pi/4 of the square about it: what is lost in all pixels, over the ball's share of them
    constexpr double ball = rt::pi / (2.2 * 2.2);
    const double due = mean_scatterings(1, extinction);
    const Statistic count =
        of_picture({.id = "B1",
                    .what = "mean number of scatterings, over 4/3 s R",
                    .number =
                        [=](const rt::Image& image) {
                            const rt::Color lost = (rt::Color(1) - region_mean(image, whole(image)) / around) / ball;
                            return (2 * lost.g - lost.b / 2) / loss / due;
                        },
                    .delta = 0.1,
                    .hint = by_ratio("the mean number of scatterings",
                                     {{0, "is nothing scattered?"},
                                      {1 / (extinction * extinction),
                                       "is the free flight multiplied by the extinction? It must be divided by it"},
                                      {1 / extinction, "is the extinction used?"}})});
    return render_check("white_medium", {scene, 32, "sobol"}, {red, count});
}

}  // namespace grade
