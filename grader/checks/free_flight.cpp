#include <fmt/format.h>

#include "checks/fragment_checks.h"
#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/render_check.h"
#include "checks/kit/white_medium.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

double extinction_of(const Row& in) { return argument<0, double, double>(in); }

/// Free flights of one extinction, not near 1, so that s and 1/s are told apart.
Check distances(Generator& random) {
    const double extinction = chance(random, 0.5) ? between(random, 2, 6) : between(random, 0.15, 0.5);
    const auto inputs = rows_of(2048, [=](Generator& draw) { return row(extinction, between(draw, 0, 1)); });
    Statistic mean = mean_of(
        "B1", "mean distance times the extinction",
        [](const Row& in, const Row& out) { return out[0] * extinction_of(in); }, 1, 1,
        by_ratio("the mean distance",
                 {{extinction * extinction, "is -log(1 - u) multiplied by the extinction? It must be divided by it"},
                  {extinction, "is the extinction used?"},
                  {1 / std::log(2), "is the logarithm of base 2? Expected the natural one"},
                  {1 / std::log(10), "is the logarithm of base 10? Expected the natural one"},
                  {0.5, "are distances uniform? -log(1 - u) is not"}}));
    mean.delta = 0.08;
    Statistic spread = uniform_in_square(
        "V3", "chi squared of the distances per degree of freedom",
        [](const Row& in, const Row& out) { return rt::vec2(-std::expm1(-out[0] * extinction_of(in)), 0.5); }, 32, 1,
        always("the distances are not distributed as s exp(-s t)"));
    return probe_check("distances", inputs, {mean, spread});
}

/// The extremes of u, where -log u may be inf: a flight of any length, but a number.
Check ends() {
    const auto inputs = rows_of(64, [](Generator& random) {
        const double ends[] = {0, 0x1p-53, 0.5, 1 - 0x1p-32, 1 - 0x1p-53};
        const double extinction = log_between(random, 1e-6, 1e6);
        return row(extinction, ends[whole_between(random, 0, 4)]);
    });
    return probe_check(
        "ends", inputs,
        {property(
            "B1", "distances below 0", [](const Row&, const Row& out) { return out[0] >= 0 ? 0.0 : 1.0; }, 0,
            "a distance is negative: log of a number below 1 is")});
}

/// A ball that absorbs, in front of an even light: each pixel keeps exp(-s l), l its ray's way through the ball.
Check attenuation(Generator& random) {
    const Place place = any_place(random);
    const double extinction = chance(random, 0.5) ? between(random, 1.5, 2) : between(random, 0.4, 0.6);
    const double radius = 1.2 / extinction, around = log_between(random, 0.3, 3);
    const View view{place({0, 0, 8 * radius}), place({0, 0, 0}), place.turned({0, 1, 0}), 14, {48, 48}};
    const std::string scene =
        fmt::format("environment = {}\n\n", toml(around * rt::vec3(1, 0.8, 0.6))) + toml(view) +
        fmt::format("[materials.ink]\ntransmittance = 1\nmedium = {{ extinction = {}, albedo = 0 }}\n\n",
                    toml(extinction)) +
        sphere("ink", place({0, 0, 0}), radius);
    const rt::Camera camera = rt::parse_scene(scene, "ink").camera;
    const rt::vec3 center = place({0, 0, 0});

    const auto way_through = [=](rt::vec2 film) {
        const rt::vec3 beside = rt::cross(center - camera.eye, view_direction(camera, film));
        return 2 * rt::safe_sqrt(radius * radius - rt::dot(beside, beside));
    };
    // pixels whose way lies between two multiples of the radius, over what they must be
    const auto over_truth = [=](double shortest, double longest) {
        return [=](const rt::Image& image) {
            double seen = 0, due = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    const double way = way_through({x + 0.5, y + 0.5});
                    if (way < shortest * radius || way > longest * radius) continue;
                    seen += image.at(x, y).r;
                    due += over_pixel(x, y, [&](rt::vec2 film) { return std::exp(-extinction * way_through(film)); });
                }
            return seen / due / around;
        };
    };
    const auto hint = [=](const std::string& what, double way) {
        return by_ratio(what, {{std::exp(-way * radius * (1 / extinction - extinction)),
                                "is the distance multiplied by the extinction? It must be divided by it"},
                               {std::exp(-way * radius * (1 - extinction)), "is the extinction used?"}});
    };
    return render_check("attenuation", {scene, 16, "sobol"},
                        {of_picture("B1", "light left after a short way, over exp(-s l)", over_truth(0.7, 1.3), 1, 0.05,
                                    hint("the light left after a short way", 1)),
                         of_picture("B1", "light left after a long way, over exp(-s l)", over_truth(1.8, 2), 1, 0.06,
                                    hint("the light left after a long way", 1.93))});
}

}  // namespace

Checks check_free_flight(Generator& random) {
    return {distances(random), ends(), attenuation(random), white_medium(random)};
}

}  // namespace grade
