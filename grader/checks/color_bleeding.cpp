#include <fmt/format.h>

#include <array>

#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/render_check.h"
#include "rt/files/scene_reader.h"
#include "statistics/furnace.h"
#include "statistics/irradiance.h"

namespace grade {

namespace {

using rt::Color, rt::Scattered, rt::vec2, rt::vec3;

vec3 normal_of(const Row& in) { return argument<0, vec3, Color, vec2>(in); }
Color albedo_of(const Row& in) { return argument<1, vec3, Color, vec2>(in); }
Scattered scattered(const Row& out) { return from_row<Scattered>(out); }

Color any_albedo(Generator& random) {
    return {between(random, 0.6, 0.9), between(random, 0.35, 0.55), between(random, 0.1, 0.3)};
}

double sum(Color c) { return c.r + c.g + c.b; }

/// The colour of the weight, its brightness apart.
Statistic tint() {
    struct Mistake {
        const char* words;
        Color (*tint)(Color albedo);
    };
    static constexpr Mistake mistakes[] = {
        {"the weight is grey: the albedo is missing", [](Color) { return Color(1); }},
        {"the albedo is squared in the weight", [](Color a) { return a * a; }},
        {"red and blue are exchanged in the weight", [](Color a) { return Color(a.b, a.g, a.r); }},
        {"red and green are exchanged in the weight", [](Color a) { return Color(a.g, a.r, a.b); }},
        {"green and blue are exchanged in the weight", [](Color a) { return Color(a.r, a.b, a.g); }},
        {"the channels of the weight are rotated", [](Color a) { return Color(a.g, a.b, a.r); }},
        {"the channels of the weight are rotated", [](Color a) { return Color(a.b, a.r, a.g); }}};
    const auto off = [](const Row& in, const Row& out, auto expected) {
        const Color due = expected(albedo_of(in)), weight = scattered(out).weight;
        if (weight == Color(0)) return 0.0;
        return rt::largest(weight / sum(weight) - due / sum(due));
    };
    Statistic s = property(
        "F2", "colour of the weight, off by",
        [=](const Row& in, const Row& out) { return off(in, out, [](Color a) { return a; }); }, 1e-3,
        "the weight does not have the colour of the albedo");
    s.cause = [=](const Observation& seen) -> std::string {
        for (const Mistake& mistake : mistakes) {
            bool all = true;
            for (std::size_t k = 0; all && k < seen.inputs.size(); ++k)
                all = off(seen.inputs[k], seen.outputs[k], mistake.tint) < 1e-3;
            if (all) return mistake.words;
        }
        return "";
    };
    return s;
}

/// Rays of one normal. Whatever their density, weight averages to the albedo, weight x cos to 2/3 of it, and weight x
/// direction along the surface to 0.
Check estimates(Generator& random) {
    const vec3 n = direction(random);
    const Color albedo = any_albedo(random);
    const rt::Frame frame = rt::frame_about(n);
    const auto inputs = rows_over_square(45, [=](rt::vec2 u) { return row(n, albedo, u); });
    const auto estimate = [=](auto f) {
        return [=](const Row&, const Row& out) {
            return sum(scattered(out).weight) / sum(albedo) * f(scattered(out).direction);
        };
    };
    const std::vector<KnownRatio> factors = {
        {1 / rt::pi, "is the weight divided by pi? With the density cos/pi, BRDF x cos / density is the albedo"},
        {rt::pi, "is the 1/pi of the BRDF missing?"},
        {2.0 / 3, "does the cosine come twice? It cancels against the density cos/pi"},
        {2 / rt::pi, "does the weight lack a factor of pi/2?"},
        {2, "is the density half of what it must be? Of uniform directions it is 1/(2 pi)"},
        {0.5, "is the density twice what it must be? Of uniform directions it is 1/(2 pi)"}};
    Statistic light = mean_of("F1", "mean weight over the albedo", estimate([](vec3) { return 1.0; }), 1, 1,
                              by_ratio("the mean weight", factors));
    find_half_a_percent(light);
    // a path that is ended at random must carry more where it goes on
    light.cause = [](const Observation& seen) -> std::string {
        double ended = 0, same = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
            const Color weight = scattered(seen.outputs[k]).weight, off = weight - albedo_of(seen.inputs[k]);
            ended += weight == Color(0);
            same += rt::largest(off) < 1e-4;
        }
        const double rows = double(seen.inputs.size());
        if (ended < 0.02 * rows || ended + same < 0.98 * rows) return "";
        return fmt::format(
            "{:.0f} % of the paths end here, and the others do not carry more for it: roulette divides the weight by "
            "the probability to go on",
            100 * ended / rows);
    };
    Statistic upwards =
        mean_of("V3", "mean of weight x cosine over the albedo", estimate([=](vec3 d) { return rt::dot(d, n); }),
                2.0 / 3, 2.0 / 3,
                by_ratio("the mean of weight x cosine",
                         {{0.75, "are directions uniform, but weighted as if their density were cos/pi?"}},
                         "directions and weights do not go together"));
    const Hint lopsided = always(
        "more light comes from one side than from the other: each coordinate of u must be used, for an angle of its "
        "own");
    Statistic x = mean_of("V3", "mean of weight x direction along the surface",
                          estimate([=](vec3 d) { return rt::dot(d, frame.x); }), 0, 1, lopsided);
    Statistic y = mean_of("V3", "mean of weight x direction across",
                          estimate([=](vec3 d) { return rt::dot(d, frame.y); }), 0, 1, lopsided);
    Statistic turn = mean_of(
        "V3", "mean of weight x (square of one component along the surface less that of the other)",
        estimate([=](vec3 d) { return rt::sqr(rt::dot(d, frame.x)) - rt::sqr(rt::dot(d, frame.y)); }), 0, 1, lopsided);
    return probe_check("estimates", inputs, {light, upwards, x, y, turn});
}

Check any_surface() {
    const auto inputs = rows_of(128, [](Generator& random) {
        const vec3 n = chance(random, 0.1) ? vec3(0, 0, -1) : direction(random);
        const Color albedo = any_albedo(random);
        return row(n, albedo, square(random));
    });
    return probe_check(
        "any_surface", inputs,
        {tint(),
         property(
             "V3", "length of the direction, off 1 by",
             [](const Row&, const Row& out) { return std::abs(glm::length(scattered(out).direction) - 1); }, 1e-4,
             "the direction is no unit vector"),
         property(
             "V3", "direction below the surface by",
             [](const Row& in, const Row& out) {
                 return std::max(0.0, -rt::dot(scattered(out).direction, normal_of(in)));
             },
             1e-6, "the direction goes below the surface: is it turned from its own frame into that about n?"),
         property(
             "V3", "weight below 0 by",
             [](const Row&, const Row& out) {
                 const Color w = scattered(out).weight;
                 return std::max({0.0, -w.r, -w.g, -w.b});
             },
             0, "a weight is negative")});
}

/// A point light in the middle of a hollow sphere: irradiance I/R^2 everywhere, and after k bounces
///
///     albedo/pi I/R^2 (1 + albedo + ... + albedo^k)
Check hollow_sphere(Generator& random) {
    const Place place = any_place(random);
    const double radius = between(random, 0.5, 2);
    const Color albedo = any_albedo(random);
    const int bounces = whole_between(random, 2, 4);
    const View view{
        place(radius * box(random, -0.3, 0.3)), place({0, 0, 2 * radius}), place.turned({0, 1, 0}), 40, {24, 24}};
    const std::string scene = fmt::format("[render]\nbounces = {}\n\n{}[materials.wall]\nalbedo = {}\n\n", bounces,
                                          toml(view), toml(albedo)) +
                              fmt::format("[[light]]\ntype = \"point\"\nposition = {}\nintensity = {}\n\n",
                                          toml(place({0, 0, 0})), toml(rt::pi * radius * radius)) +
                              sphere("wall", place({0, 0, 0}), radius);

    const auto after = [](double a, int k) { return a * furnace_radiance(1, a, k); };
    std::vector<Statistic> channels;
    for (int c = 0; c < 3; ++c) {
        const std::string name = std::array{"red", "green", "blue"}[std::size_t(c)];
        const double a = albedo[c], truth = after(a, bounces);
        channels.push_back(of_picture(
            "F2", name + " radiance after some bounces, over what must be",
            [=](const rt::Image& image) { return region_mean(image, whole(image))[c] / truth; }, 1, 0.02,
            by_ratio(fmt::format("the {} light in a hollow sphere after {} bounces", name, bounces),
                     {{after(a / rt::pi, bounces) * rt::pi / truth, "is the weight divided by pi?"},
                      {a * (bounces + 1) / truth, "is the albedo missing from the weight?"},
                      {a * (1 - std::pow(a * a, bounces + 1)) / (1 - a * a) / truth,
                       "is the albedo squared in the weight?"}})));
    }
    return render_check("hollow_sphere", {scene, 16, "sobol"}, channels);
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
    const std::string scene =
        fmt::format("[render]\nbounces = 1\n\n{}[materials.floor]\nalbedo = {}\n\n[materials.wall]\nalbedo = {}\n\n",
                    toml(view), toml(floor), toml(paint)) +
        fmt::format("[[light]]\ntype = \"directional\"\ntoward = {}\nirradiance = {}\n\n", toml(place.turned(toward)),
                    toml(light)) +
        quad("wall", wall.center, wall.u, wall.v) + quad("floor", place({1, 0, 0}), 0.7 * axes.x, 0.7 * axes.y);

    const rt::Camera camera = rt::parse_scene(scene, "wall").camera;
    const auto over_truth = [=](double low, double high) {
        return [=](const rt::Image& image) {
            double seen = 0, due = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    const auto spot = [&](vec2 film) { return seen_on_plane(camera, film, place.origin, axes.z); };
                    const double away = rt::dot(spot({x + 0.5, y + 0.5}) - place.origin, axes.x);
                    if (away < low || away > high) continue;
                    seen += sum(image.at(x, y) / (floor * paint)) / 3;
                    due += light * toward.x / rt::sqr(rt::pi) *
                           over_pixel(x, y, [&](vec2 film) { return quad_irradiance(wall, spot(film), axes.z); });
                }
            return seen / due;
        };
    };
    const std::vector<KnownRatio> known = {{1 / rt::pi, "is the weight divided by pi?"},
                                           {rt::pi, "is the 1/pi of the BRDF missing?"}};
    return render_check(
        "beside_wall", {scene, 64, "sobol"},
        {of_picture("F2", "light from a wall on the floor close to it, over what must be", over_truth(0.5, 0.8), 1,
                    0.06, by_ratio("the light that a wall throws on the floor close to it", known)),
         of_picture("F2", "light from a wall on the floor further away, over what must be", over_truth(1.2, 1.5), 1,
                    0.08,
                    by_ratio("the light that a wall throws on the floor further away", known,
                             "are the directions distributed as the weight supposes?"))});
}

}  // namespace

Checks check_color_bleeding(Generator& random) {
    return {any_surface(), estimates(random), hollow_sphere(random), beside_wall(random)};
}

}  // namespace grade
