#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/fragment_checks.h"
#include "checks/kit/lobe_check.h"
#include "checks/kit/lobe_picture.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

/// Share of unpolarised light that a surface of glass transmits.
double transmitted_share(double angle, double ior) {
    const double c = std::cos(angle), t = std::sqrt(1 - rt::sqr(std::sin(angle) / ior));
    const double s = (c - ior * t) / (c + ior * t), p = (ior * c - t) / (ior * c + t);
    return 1 - (s * s + p * p) / 2;
}

/// The lobe of a ray of direction d that enters glass with the given normal.
Lobe entering(rt::vec3 d, rt::vec3 normal, double ior, double exponent) {
    const double cosine = -rt::dot(d, normal), sine = rt::safe_sqrt(1 - cosine * cosine);
    const rt::vec3 along = (d + cosine * normal) / ior;
    return {along - std::sqrt(1 - sine * sine / (ior * ior)) * normal, -normal, exponent,
            transmitted_share(std::acos(std::min(cosine, 1.0)), ior)};
}

std::string frosted(double ior, double exponent) {
    return fmt::format("[materials.frosted]\ntransmittance = 1\nior = {}\nexponent = {}\n\n", toml(ior),
                       toml(exponent));
}

/// Frosted glass before a sky of light, seen at all angles: part of the lobe does not cross the surface.
Check sky(Generator& random) {
    const Place place = any_place(random);
    const double n = between(random, 6, 12), ior = between(random, 1.3, 1.7), around = log_between(random, 0.3, 3);
    const View view{place({-1, 0, 1}),
                    place({0, 0, 0}),
                    place.turned({0, 0, 1}),
                    60,
                    {48, 48}};  // 15 to 75 degrees from the normal
    const std::string scene =
        toml(view) + fmt::format("[materials.sky]\nemission = {}\nsampled = false\n\n", toml(around)) +
        frosted(ior, n) + quad("frosted", place({0, 0, 0}), 100.0 * place.axes.x, 100.0 * place.axes.y) +
        disc("sky", place({0, 0, -0.1}), place.axes.z, 10000);
    const rt::Camera camera = rt::parse_scene(scene, "sky").camera;

    const auto albedo = tabulated_albedo(n);
    const auto angle_at = [=](rt::vec2 film) {
        return std::acos(-rt::dot(view_direction(camera, film), place.axes.z));
    };
    const auto refracted = [=](double angle) { return std::asin(std::sin(angle) / ior); };
    const auto over_truth = [=](double low, double high) {
        return [=](const rt::Image& image) {
            double seen = 0, due = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    const double angle = angle_at({x + 0.5, y + 0.5});
                    if (angle * 180 / rt::pi < low || angle * 180 / rt::pi > high) continue;
                    seen += brightness(image.at(x, y));
                    due += transmitted_share(angle, ior) * albedo(refracted(angle));
                }
            return seen / due / around;
        };
    };
    const auto hint = [=](const std::string& where, double degrees) {
        const double angle = degrees * rt::pi / 180, due = albedo(refracted(angle));
        return by_ratio(
            "what frosted glass lets through " + where,
            {{albedo(angle) / due, "is the lobe about the direction of travel? It must be refracted"},
             {albedo(std::min(rt::pi / 2, std::asin(std::min(1.0, std::sin(angle) * ior)))) / due,
              "are the two indices of refraction exchanged?"},
             {(n + 1) / (n + 2), "does n + 1 stand for n + 2 in the BTDF?"},
             {(n + 2) / (n + 1), "is the cosine at the surface missing, or does (n + 2)/(n + 1) count twice?"},
             {1 / due, "does the weight have the cosine at the surface, and is it 0 where the ray does not cross?"}},
            "expected (n + 2)/(2 pi) cos(alpha)^n x |cosine at the surface| / density, 0 where the ray does not cross");
    };
    return render_check("sky", {scene, 8, "sobol"},
                        {of_picture("P2", "light let through where it is seen steeply, over what must be",
                                    over_truth(0, 30), 1, 0.05, hint("where it is seen steeply", 24)),
                         of_picture("P3", "light let through where it is seen at 65 degrees, over what must be",
                                    over_truth(60, 70), 1, 0.05, hint("where it is seen at 65 degrees", 65))});
}

/// The blurred image of a lamp behind frosted glass.
Check lamp_behind(Generator& random) {
    const Place place = any_place(random);
    const double n = between(random, 8, 14), ior = between(random, 1.3, 1.7), angle = between(random, 0.6, 0.9),
                 inside = std::asin(std::sin(angle) / ior);
    const rt::Sphere shining{place({4 * std::sin(inside), 0, -4 * std::cos(inside)}), 0.9};
    const View view{
        place({-4 * std::sin(angle), 0, 4 * std::cos(angle)}), place({0, 0, 0}), place.turned({0, 0, 1}), 50, {24, 24}};
    const std::string scene = toml(view) + "[materials.lamp]\nemission = 1\nsampled = false\n\n" + frosted(ior, n) +
                              sphere("lamp", shining.center, shining.radius) +
                              quad("frosted", place({0, 0, 0}), 100.0 * place.axes.x, 100.0 * place.axes.y);
    const rt::vec3 up = place.axes.z;
    const LobeSurface pane{rt::parse_scene(scene, "lamp").camera, place.origin, up,
                           [=](rt::vec3 d, double exponent) { return entering(d, up, ior, exponent); }};
    return render_check("lamp", {scene, 64, "sobol"}, blurred_lamp(pane, shining, n, "the refracted direction"));
}

}  // namespace

Checks check_translucency(Generator& random) {
    using rt::vec3;
    const double low = between(random, 1, 1.1), high = between(random, 1.35, 1.8);
    Checks checks;
    struct Case {
        const char* name;
        double angle, from, to;
    };
    for (const Case& c : {Case{"head_on", 0, low, high}, Case{"into_the_denser", between(random, 0.9, 1.2), low, high},
                          Case{"into_the_thinner", between(random, 0.3, 0.5), high, low}}) {
        const double n = between(random, 6, 12), sine = std::sin(c.angle) * c.from / c.to;
        const rt::Frame frame = rt::frame_about(direction(random));
        const vec3 normal = frame.z;
        const vec3 d = std::sin(c.angle) * frame.x - std::cos(c.angle) * normal,
                   axis = sine * frame.x - std::sqrt(1 - sine * sine) * normal;
        const auto inputs = [=](Generator& draws) {
            return repeat(
                rows_over_square(32, [=](rt::vec2 u) { return row(d, normal, c.from, c.to, n, u); })(draws));
        };
        // where the wrong refraction is total, nothing passes
        const double weight = (n + 2) / (n + 1), swapped = std::sin(c.angle) * c.to / c.from;
        const vec3 wrong_axis = swapped < 1 ? swapped * frame.x - std::sqrt(1 - swapped * swapped) * normal : -normal;
        const std::vector<LobeSuspect> suspects = {
            lobe_about("the lobe is about the direction of travel; expected about the refracted direction", d, -normal,
                       n, weight),
            lobe_about("the two indices of refraction are swapped", wrong_axis, -normal, n, swapped < 1 ? weight : 0),
            lobe_about("the lobe is about the normal; expected about the refracted direction", -normal, -normal, n,
                       weight)};
        checks.push_back(
            probe_check(c.name, inputs, lobe_statistics({axis, -normal, n, "the refracted direction", suspects})));
    }

    const auto total = rows_of(64, [=](Generator& draw) {
        const vec3 normal = direction(draw);
        const vec3 d = -tilted(draw, normal, between(draw, std::asin(low / high) + 0.05, 1.5));
        return row(d, normal, high, low, between(draw, 5, 50), square(draw));
    });
    checks.push_back(
        probe_check("total_reflection", total,
                    {property(
                        "F3", "weight at total internal reflection",
                        [](const Row&, const Row& out) { return rt::largest(from_row<rt::Scattered>(out).weight); }, 0,
                        "at total internal reflection nothing passes: the weight is 0")}));
    checks.push_back(sky(random));
    checks.push_back(lamp_behind(random));
    return checks;
}

}  // namespace grade
