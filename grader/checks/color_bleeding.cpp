#include "asked/color_bleeding.h"
#include "checks/kit/warp.h"
#include "statistics/closed_forms.h"

namespace grade {

namespace {

using rt::Color, rt::Scattered, rt::vec2, rt::vec3;

Color any_albedo(Generator& random) {
    return {between(random, 0.6, 0.9), between(random, 0.35, 0.55), between(random, 0.1, 0.3)};
}

double sum(Color c) { return c.r + c.g + c.b; }

/// The colour of the weight, its brightness apart, against a function of the albedo.
template <class Tint>
RowNumber tint_error(Tint tint) {
    return of_call<rt::color_bleeding>([=](const Scattered& s, vec3, Color albedo, vec2) {
        const Color due = tint(albedo);
        return s.weight == Color(0) ? 0.0 : rt::largest(s.weight / sum(s.weight) - due / sum(due));
    });
}

Statistic tint() {
    return property(
        {.id = "F2",
         .what = "colour of the weight, off by",
         .violation = tint_error([](Color a) { return a; }),
         .tolerance = 1e-3,
         .says = "the weight does not have the colour of the albedo",
         .mistakes = {
             {"the weight is grey; expected the albedo, channel by channel",
              tint_error([](Color) { return Color(1); })},
             {"the albedo is squared in the weight", tint_error([](Color a) { return a * a; })},
             {"red and blue are exchanged in the weight", tint_error([](Color a) { return Color(a.b, a.g, a.r); })},
             {"red and green are exchanged in the weight", tint_error([](Color a) { return Color(a.g, a.r, a.b); })},
             {"green and blue are exchanged in the weight", tint_error([](Color a) { return Color(a.r, a.b, a.g); })},
             {"the channels of the weight are rotated", tint_error([](Color a) { return Color(a.g, a.b, a.r); })},
             {"the channels of the weight are rotated", tint_error([](Color a) { return Color(a.b, a.r, a.g); })}}});
}

/// A path that is ended at random must carry more where it goes on.
std::string unpaid_roulette(const Observation& seen) {
    double ended = 0, same = 0;
    for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
        const Color weight = result<rt::color_bleeding>(seen.outputs[k]).weight;
        ended += weight == Color(0);
        same += rt::largest(weight - argument<rt::color_bleeding, 1>(seen.inputs[k])) < 1e-4;
    }
    const double rows = double(seen.inputs.size());
    if (ended < 0.02 * rows || ended + same < 0.98 * rows) return "";
    return fmt::format(
        "{:.0f} % of the paths end here, and the others do not carry more for it: roulette divides the weight by "
        "the probability to go on",
        100 * ended / rows);
}

/// Rays of one normal. Whatever their density, weight averages to the albedo, weight x cos to 2/3 of it, and weight x
/// direction along the surface to 0.
Check estimates(Generator& random) {
    const vec3 n = direction(random);
    const Color albedo = any_albedo(random);
    const rt::Frame frame = rt::frame_about(n);
    const auto estimate = [=](auto f) {
        return of_call<rt::color_bleeding>(
            [=](const Scattered& s) { return sum(s.weight) / sum(albedo) * f(s.direction); });
    };
    const Statistic light = find_half_a_percent(mean_of(
        {.id = "F1",
         .what = "mean weight over the albedo",
         .number = estimate([](vec3) { return 1.0; }),
         .hint = by_ratio(
             "the mean weight",
             {{1 / rt::pi, "is the weight divided by pi? With the density cos/pi, BRDF x cos / density is the albedo"},
              {rt::pi, "is the 1/pi of the BRDF missing?"},
              {2.0 / 3, "does the cosine come twice? It cancels against the density cos/pi"},
              {2 / rt::pi, "does the weight lack a factor of pi/2?"},
              {2, "is the density half of what it must be? Of uniform directions it is 1/(2 pi)"},
              {0.5, "is the density twice what it must be? Of uniform directions it is 1/(2 pi)"}}),
         .cause = unpaid_roulette}));
    const Statistic upwards =
        mean_of({.id = "V3",
                 .what = "mean of weight x cosine over the albedo",
                 .number = estimate([=](vec3 d) { return rt::dot(d, n); }),
                 .truth = 2.0 / 3,
                 .hint = by_ratio("the mean of weight x cosine",
                                  {{0.75, "are directions uniform, but weighted as if their density were cos/pi?"}},
                                  "directions and weights do not go together")});
    const auto lopsided = [&](const std::string& what, auto f) {
        return mean_of({.id = "V3",
                        .what = "mean of weight x " + what,
                        .number = estimate(f),
                        .truth = 0,
                        .hint = always("more light comes from one side than from the other: each coordinate of u must "
                                       "be used, for an angle of its own")});
    };
    return probe_check(
        "estimates", rows_over_square(45, [=](vec2 u) { return row(n, albedo, u); }),
        {light, upwards, lopsided("direction along the surface", [=](vec3 d) { return rt::dot(d, frame.x); }),
         lopsided("direction across", [=](vec3 d) { return rt::dot(d, frame.y); }),
         lopsided("(square of one component along the surface less that of the other)",
                  [=](vec3 d) { return rt::sqr(rt::dot(d, frame.x)) - rt::sqr(rt::dot(d, frame.y)); })});
}

/// Dark and bright surfaces, and channels that are black or full, which leave the others as they are.
Check any_albedo_at_all() {
    constexpr int repeats = 40;
    const auto once = rows_of_channels(1, [](Generator& draw, int, auto change) {
        const Color albedo =
            chance(draw, 0.5) ? Color(between(draw, 0.01, 0.05)) + box(draw, 0, 0.05) : box(draw, 0.8, 1);
        return row(scene_direction(draw), change(0, albedo), square(draw));
    });
    const auto inputs = [once](Generator& random) {
        Rows rows;
        for (int k = 0; k < repeats; ++k) rows = joined(std::move(rows), once(random));
        return rows;
    };
    const Statistic in_all_channels = property(
        {.id = "F2",
         .what = "weight over albedo, by how much channels differ",
         .violation = of_call<rt::color_bleeding>([](const Scattered& s, vec3, Color albedo, vec2) {
             double least = rt::inf, most = 0;
             for (int c = 0; c < 3; ++c) {
                 if (albedo[c] == 0 && s.weight[c] != 0) return 1.0;
                 if (albedo[c] == 0) continue;
                 least = std::min(least, s.weight[c] / albedo[c]), most = std::max(most, s.weight[c] / albedo[c]);
             }
             return least < rt::inf ? (most - least) / std::max(most, 1e-9) : 0;
         }),
         .tolerance = 1e-4,
         .says = "a channel of the weight is not the albedo's: is one channel taken for all, or the albedo cut off?"});
    const Statistic mean = mean_of(
        {.id = "F2",
         .what = "mean of weight x cosine over the albedo, also where that is nearly 0 or 1",
         .number = of_call<rt::color_bleeding>([](const Scattered& s, vec3 n, Color albedo, vec2) {
             return rt::largest(albedo) > 0 ? rt::largest(s.weight) / rt::largest(albedo) * rt::dot(s.direction, n)
                                            : 2.0 / 3;
         }),
         .truth = 2.0 / 3,
         .delta0 = 0.002,
         .delta = 0.05,
         .hint = always("surfaces that are nearly black or white, or have a channel that is, get another weight "
                        "than others: the weight is the albedo's, whatever that is")});
    return probe_check("any_albedo", inputs, {in_all_channels, mean});
}

Check any_surface() {
    const auto inputs = rows_of(128, [](Generator& random) {
        const vec3 n = scene_direction(random);
        const Color albedo = any_albedo(random);
        return row(n, albedo, chance(random, 0.25) ? end_of_square(random) : square(random));
    });
    const Statistic below =
        property({.id = "V3",
                  .what = "direction below the surface by",
                  .violation = of_call<rt::color_bleeding>(
                      [](const Scattered& s, vec3 n, Color, vec2) { return std::max(0.0, -rt::dot(s.direction, n)); }),
                  .tolerance = 1e-6,
                  .says = "the direction goes below the surface: is it turned from its own frame into that about n?"});
    const Statistic negative = property({.id = "V3",
                                         .what = "weight below 0 by",
                                         .violation = of_call<rt::color_bleeding>([](const Scattered& s) {
                                             return std::max({0.0, -s.weight.r, -s.weight.g, -s.weight.b});
                                         }),
                                         .says = "a weight is negative"});
    return probe_check("any_surface", inputs, {tint(), unit_direction<rt::color_bleeding>("V3"), below, negative});
}

/// A point light in the middle of a hollow sphere: irradiance I/R^2 everywhere, and after k bounces
///
///     albedo/pi I/R^2 (1 + albedo + ... + albedo^k)
Check hollow_sphere(Generator& random) {
    const Place place = any_place(random);
    const double radius = between(random, 0.5, 2);
    const Color albedo = any_albedo(random);
    const int bounces = whole_between(random, 2, 4);
    const std::string scene = scene_from("hollow_sphere.toml", {{"bounces", bounces},
                                                                {"eye", place(radius * box(random, -0.3, 0.3))},
                                                                {"target", place({0, 0, 2 * radius})},
                                                                {"up", place.turned({0, 1, 0})},
                                                                {"albedo", albedo},
                                                                {"center", place({0, 0, 0})},
                                                                {"intensity", rt::pi * radius * radius},
                                                                {"radius", radius}});
    const auto after = [](double a, int k) { return a * furnace_radiance(1, a, k); };
    return render_check(
        "hollow_sphere", {scene, 16, "sobol"}, rgb([&](int c, const std::string& name) {
            const double a = albedo[c], truth = after(a, bounces);
            return of_picture(
                {.id = "F2",
                 .what = name + " radiance after some bounces, over what must be",
                 .number = [=](const rt::Image& image) { return region_mean(image, whole(image))[c] / truth; },
                 .delta = 0.02,
                 .hint = by_ratio(fmt::format("the {} light in a hollow sphere after {} bounces", name, bounces),
                                  {{after(a / rt::pi, bounces) * rt::pi / truth, "is the weight divided by pi?"},
                                   {a * (bounces + 1) / truth, "is the albedo missing from the weight?"},
                                   {a * (1 - std::pow(a * a, bounces + 1)) / (1 - a * a) / truth,
                                    "is the albedo squared in the weight?"}})});
        }));
}

/// A coloured wall in the light beside a floor in the dark: after one bounce the floor shows
///
///     albedo/pi (wall's albedo/pi E) quad_irradiance
Check beside_wall(Generator& random) {
    const Place place = any_place(random);
    const rt::Frame& axes = place.axes;
    const rt::Quad wall{place({0, 0, 0.7}), between(random, 0.6, 0.9) * axes.y, 0.5 * axes.z};
    const Color floor(0.9, 0.8, 0.7), paint = any_albedo(random);
    const double light = 10;
    const vec3 toward = rt::unit({1, 0, -0.1});  // from below the floor
    const View view{place({1, 0, 4}), place({1, 0, 0}), place.turned({0, 1, 0}), 14, {24, 24}};
    const std::string scene = scene_table("[render]", {{"bounces", 1}}) + toml(view) +
                              material("floor", {{"albedo", floor}}) + material("wall", {{"albedo", paint}}) +
                              directional_light(place.turned(toward), light) + quad("wall", wall) +
                              quad("floor", place({1, 0, 0}), 0.7 * axes.x, 0.7 * axes.y);

    const rt::Camera camera = camera_of(scene);
    const auto spot = [=](vec2 film) { return seen_on_plane(camera, film, place.origin, axes.z); };
    const auto light_at = [&](const std::string& where, double low, double high, double delta,
                              const std::string& else_words) {
        return of_picture({.id = "F2",
                           .what = "light from a wall on the floor " + where + ", over what must be",
                           .number = light_over_due(
                               camera.size,
                               [=](int x, int y) {
                                   const double away = rt::dot(spot({x + 0.5, y + 0.5}) - place.origin, axes.x);
                                   return away >= low && away <= high;
                               },
                               [=](Color c) { return sum(c / (floor * paint)) / 3; },
                               [=](int x, int y) {
                                   return light * toward.x / rt::sqr(rt::pi) * over_pixel(x, y, [&](vec2 film) {
                                              return quad_irradiance(wall, spot(film), axes.z);
                                          });
                               }),
                           .delta = delta,
                           .hint = by_ratio("the light that a wall throws on the floor " + where,
                                            {{1 / rt::pi, "is the weight divided by pi?"},
                                             {rt::pi, "is the 1/pi of the BRDF missing?"}},
                                            else_words)});
    };
    return render_check(
        "beside_wall", {scene, 64, "sobol"},
        {light_at("close to it", 0.5, 0.8, 0.06, ""),
         light_at("further away", 1.2, 1.5, 0.08, "are the directions distributed as the weight supposes?")});
}

}  // namespace

Checks check_color_bleeding(Generator& random) {
    const auto row_with = [](Generator& draw, vec2 u) { return row(exact_direction(draw), any_albedo(draw), u); };
    Check axes = axes_of_the_world(row_with);
    // whatever the density is, weight x cosine has the mean of albedo x 2/3
    axes.statistics.push_back(
        mean_of({.id = "V3",
                 .what = "mean of weight x cosine over the albedo, about the axes of the world",
                 .number = of_call<rt::color_bleeding>([](const Scattered& s, vec3 n, Color albedo, vec2) {
                     return s.weight.r / albedo.r * rt::dot(s.direction, n);
                 }),
                 .truth = 2.0 / 3,
                 .hint = always("about an axis of the world, directions are not those about other normals")}));
    // BRDF x cosine / weight is the density
    const Check density =
        own_density([](Generator& draw, vec2 u) { return row(scene_direction(draw), any_albedo(draw), u); },
                    {of_call<rt::color_bleeding>([](const Scattered& s) { return s.direction; }),
                     of_call<rt::color_bleeding>([](const Scattered& s, vec3 n, Color albedo, vec2) {
                         return s.weight.r > 0 ? albedo.r / rt::pi * rt::dot(s.direction, n) / s.weight.r : 0;
                     }),
                     "the density that the weight supposes"});
    return {any_surface(),         any_albedo_at_all(), axes, estimates(random), density,
            hollow_sphere(random), beside_wall(random)};
}

}  // namespace grade
