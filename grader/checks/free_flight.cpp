#include "asked/free_flight.h"
#include "checks/kit/own_density.h"
#include "checks/kit/white_medium.h"

namespace grade {

namespace {

/// Free flights of one extinction, not near 1, so that s and 1/s are told apart.
Check distances(Generator& random) {
    const double extinction = chance(random, 0.5) ? between(random, 2, 6) : between(random, 0.15, 0.5);
    const auto inputs = rows_of(2048, [=](Generator& draw) { return row(extinction, between(draw, 0, 1)); });
    const Statistic mean = mean_of(
        {.id = "B1",
         .what = "mean distance times the extinction",
         .number = of_call<rt::free_flight>([](double t, double s, double) { return t * s; }),
         .delta = 0.08,
         .hint = by_ratio(
             "the mean distance",
             {{extinction * extinction, "is -log(1 - u) multiplied by the extinction? It must be divided by it"},
              {extinction, "is the extinction used?"},
              {1 / std::log(2), "is the logarithm of base 2? Expected the natural one"},
              {1 / std::log(10), "is the logarithm of base 10? Expected the natural one"},
              {0.5, "are distances uniform? -log(1 - u) is not"}})});
    const Statistic spread = uniform_in_square({.id = "V3",
                                                .what = "chi squared of the distances per degree of freedom",
                                                .point = of_call<rt::free_flight>([](double t, double s, double) {
                                                    return rt::vec2(-std::expm1(-t * s), 0.5);
                                                }),
                                                .columns = 32,
                                                .rows = 1,
                                                .hint = always("the distances are not distributed as s exp(-s t)")});
    return probe_check("distances", inputs, {mean, spread});
}

/// The extremes of u, where -log u may be inf: a flight of any length, but a number.
Check ends() {
    const auto inputs = rows_of(64, [](Generator& random) {
        const double ends[] = {0, 0x1p-53, 0.5, 1 - 0x1p-32, 1 - 0x1p-53};
        const double extinction = log_between(random, 1e-6, 1e6);
        return row(extinction, ends[whole_between(random, 0, 4)]);
    });
    const auto unless = [](auto holds) {
        return of_call<rt::free_flight>([=](double t) { return holds(t) ? 0.0 : 1.0; });
    };
    return probe_check(
        "ends", inputs,
        {property({.id = "B1",
                   .what = "distances below 0",
                   .violation = unless([](double t) { return t >= 0; }),
                   .says = "a distance is negative: log of a number below 1 is"}),
         property({.id = "B1",
                   .what = "distances without end",
                   .violation = unless([](double t) { return t < rt::inf; }),
                   .says = "a distance is infinite: u can be 0, and log(u) has no end there; 1 - u is never 0"})});
}

/// What distances exceed three mean ones by, exp(-3) of a mean distance: no length is the greatest.
Statistic longest() {
    constexpr double beyond = 3;
    return mean_of({.id = "B1",
                    .what = "what distances exceed three mean distances by, over exp(-3) of one",
                    .number = of_call<rt::free_flight>(
                        [](double t, double s, double) { return std::max(t * s - beyond, 0.0) * std::exp(beyond); }),
                    .delta0 = 0.005,
                    .delta = 0.05,
                    .hint = by_ratio("what distances exceed three mean distances by", {},
                                     "are long flights cut off, or bent? There is no longest one")});
}

/// Extinctions from 0.001 to 10,000 per metre: numbers u spread evenly, so that little noise is left.
Check any_extinction() {
    constexpr int each = 512;
    const auto inputs = [](Generator& random) {
        Rows rows;
        for (int decade = -3; decade < 4; ++decade)
            for (int k = 0; k < each; ++k)
                rows.push_back(row(std::pow(10, decade + between(random, 0, 1)), (k + between(random, 0, 1)) / each));
        return rows;
    };
    const Statistic spread =
        uniform_in_square({.id = "V3",
                           .what = "chi squared of the distances per degree of freedom, from 0.001 to 10,000 per metre",
                           .point = of_call<rt::free_flight>(
                               [](double t, double s, double) { return rt::vec2(-std::expm1(-t * s), 0.5); }),
                           .columns = 16,
                           .rows = 1,
                           .delta0 = 1,
                           .delta = 1.5,
                           .hint = always("the distances are not distributed as s exp(-s t)")});
    return probe_check("any_extinction", inputs,
                       {mean_of({.id = "B1",
                                 .what = "mean distance times the extinction, from 0.001 to 10,000 per metre",
                                 .number = of_call<rt::free_flight>([](double t, double s, double) { return t * s; }),
                                 .delta0 = 0.002,
                                 .delta = 0.012,
                                 .hint = by_ratio("the mean distance of extinctions from 0.001 to 10,000 per metre", {},
                                                  "is the extinction clamped, or has it a factor?")}),
                        spread, longest()});
}

/// s exp(-s t), at each distance.
Check exponential() {
    return own_density(
        [](Generator& draw, rt::vec2 u) { return row(log_between(draw, 0.1, 10), u.x); },
        {of_call<rt::free_flight>([](double t) { return rt::vec3(t, 0, 0); }),
         of_call<rt::free_flight>([](double t, double s, double) { return s * std::exp(-s * t); }), "s exp(-s t)", 1});
}

/// A ball that absorbs, in front of an even light: each pixel keeps exp(-s l), l its ray's way through the ball.
Check attenuation(Generator& random) {
    const Place place = any_place(random);
    const double extinction = chance(random, 0.5) ? between(random, 1.5, 2) : between(random, 0.4, 0.6);
    const double radius = 1.2 / extinction, around = log_between(random, 0.3, 3);
    const std::string scene = environment(around * rt::vec3(1, 0.8, 0.6)) +
                              toml(place.from_above(8 * radius, 14, {48, 48})) +
                              milk("ink", extinction, rt::vec3(0), 0) + sphere("ink", place({0, 0, 0}), radius);
    const rt::Camera camera = camera_of(scene);
    const rt::vec3 center = place({0, 0, 0});
    const auto way_through = [=](rt::vec2 film) {
        const rt::vec3 beside = rt::cross(center - camera.eye, view_direction(camera, film));
        return 2 * rt::safe_sqrt(radius * radius - rt::dot(beside, beside));
    };
    // pixels whose way lies between two multiples of the radius
    const auto left_after = [&](const std::string& which, double shortest, double longest, double typical,
                                double delta) {
        const PictureNumber over_due = light_over_due(
            camera.size,
            [=](int x, int y) {
                const double way = way_through({x + 0.5, y + 0.5});
                return way >= shortest * radius && way <= longest * radius;
            },
            [](rt::Color c) { return c.r; },
            [=](int x, int y) {
                return over_pixel(x, y, [&](rt::vec2 film) { return std::exp(-extinction * way_through(film)); });
            });
        return of_picture(
            {.id = "B1",
             .what = "light left after a " + which + " way, over exp(-s l)",
             .number = [=](const rt::Image& image) { return over_due(image) / around; },
             .delta = delta,
             .hint = by_ratio("the light left after a " + which + " way",
                              {{std::exp(-typical * radius * (1 / extinction - extinction)),
                                "is the distance multiplied by the extinction? It must be divided by it"},
                               {std::exp(-typical * radius * (1 - extinction)), "is the extinction used?"}})});
    };
    return render_check("attenuation", {scene, 16, "sobol"},
                        {left_after("short", 0.7, 1.3, 1, 0.05), left_after("long", 1.8, 2, 1.93, 0.06)});
}

}  // namespace

Checks check_free_flight(Generator& random) {
    Checks checks = {distances(random),   any_extinction(), exponential(),
                     attenuation(random), ends(),           white_medium(random)};
    // any distances above 0 pass the last two
    for (std::size_t k = 0; k < 4; ++k) checks[k].share = 3;
    return checks;
}

}  // namespace grade
