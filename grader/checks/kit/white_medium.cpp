#include "checks/kit/white_medium.h"

#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/kit/render_check.h"
#include "statistics/projection.h"
#include "statistics/region.h"

namespace grade {

Check white_medium(Generator& random) {
    const Place place = any_place(random);
    const double g = (chance(random, 0.5) ? 1 : -1) * between(random, 0.3, 0.5), extinction = between(random, 1, 1.6);
    const double around = log_between(random, 0.3, 3);
    constexpr double loss = 0.03, far = 60;
    constexpr int size = 16;
    const View view{place({0, 0, far}),
                    place({0, 0, 0}),
                    place.turned({0, 1, 0}),
                    2 * std::atan(1.1 / far) * 180 / rt::pi,
                    {size, size}};
    const std::string scene =
        fmt::format("environment = {}\n\n", toml(around)) + toml(view) +
        fmt::format(
            "[materials.milk]\ntransmittance = 1\nmedium = {{ extinction = {}, albedo = [1, {}, {}], g = {} }}\n\n",
            toml(extinction), 1 - loss, 1 - 2 * loss, toml(g)) +
        sphere("milk", place({0, 0, 0}), 1);
    Statistic red = of_picture(
        "B1", "radiance of a white medium, over that of its surroundings",
        [=](const rt::Image& image) {
            return region_mean(image, {4, 4, 8, 8}).r / around;
        },
        1, 0.05,
        [](double value, double) {
            return fmt::format(
                "a white medium where light comes from everywhere alike must be invisible, but its radiance is {:.3g} "
                "times that of its surroundings: is the density normalised, and that of the direction?",
                value);
        });
    // the ball takes pi/4 of the square about it: what is lost in all pixels, over the ball's share of them
    constexpr double ball = rt::pi / (2.2 * 2.2);
    const double due = mean_scatterings(1, extinction);
    Statistic count = of_picture(
        "B1", "mean number of scatterings, over 4/3 s R",
        [=](const rt::Image& image) {
            const rt::Color lost = (rt::Color(1) - region_mean(image, whole(image)) / around) / ball;
            return (2 * lost.g - lost.b / 2) / loss / due;
        },
        1, 0.1,
        by_ratio("the mean number of scatterings",
                 {{0, "is nothing scattered?"},
                  {1 / (extinction * extinction),
                   "is the free flight multiplied by the extinction? It must be divided by it"},
                  {1 / extinction, "is the extinction used?"}}));
    return render_check("white_medium", {scene, 32, "sobol"}, {red, count});
}

}  // namespace grade
