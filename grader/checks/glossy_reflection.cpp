#include "asked/glossy_reflection.h"
#include "checks/kit/lobe_check.h"
#include "checks/kit/lobe_picture.h"

namespace grade {

namespace {

using rt::vec3;

/// A glossy ball where light comes from everywhere alike: seen at an angle, part of the lobe is below the surface.
Check ball(Generator& random) {
    const Place place = any_place(random);
    const double n = between(random, 6, 12), around = log_between(random, 0.3, 3);
    const rt::Color reflectance(between(random, 0.7, 1), between(random, 0.4, 0.6), between(random, 0.1, 0.3));
    const std::string scene = environment(around) + toml(place.from_above(10, 12, {48, 48})) +
                              material("steel", {{"reflectance", reflectance}, {"exponent", n}}) +
                              sphere("steel", place({0, 0, 0}), 1);
    const rt::Camera camera = camera_of(scene);
    const auto albedo = tabulated_albedo(n);
    const auto angle_at = [=](rt::vec2 film) {  // from the normal
        const vec3 beside = rt::cross(place.origin - camera.eye, view_direction(camera, film));
        const double sine = glm::length(beside);
        return sine < 1 ? std::asin(sine) : rt::pi;
    };
    const auto seen_at = [&](const std::string& id, const std::string& where, double low, double high, double degrees,
                             double delta) {
        const PictureNumber over_due = light_over_due(
            camera.size,
            [=](int x, int y) {
                const double angle = angle_at({x + 0.5, y + 0.5}) * 180 / rt::pi;
                return angle >= low && angle <= high;
            },
            [=](rt::Color c) { return brightness(c / reflectance); },
            [=](int x, int y) { return over_pixel(x, y, [&](rt::vec2 film) { return albedo(angle_at(film)); }); });
        return of_picture(
            {.id = id,
             .what = "light that it reflects " + where + ", over what must be",
             .number = [=](const rt::Image& image) { return over_due(image) / around; },
             .delta = delta,
             .hint = hint_later([=] {
                 return by_ratio(
                     "what a glossy ball reflects " + where,
                     {{(n + 1) / (n + 2), "does n + 1 stand for n + 2 in the BRDF?"},
                      {(n + 2) / (n + 1), "is the cosine at the surface missing, or does (n + 2)/(n + 1) count twice?"},
                      {1 / albedo(degrees * rt::pi / 180),
                       "does the weight have the cosine at the surface, and is it 0 below the surface?"}},
                     "expected (n + 2)/(2 pi) cos(alpha)^n x cosine at the surface / density, 0 below the surface");
             })});
    };
    return render_check("ball", {scene, 16, "sobol"},
                        {seen_at("P2", "where it is seen head on", 0, 25, 0, 0.05),
                         seen_at("P3", "where it is seen at 60 degrees", 53, 65, 60, 0.05),
                         seen_at("P3", "near its rim", 70, 78, 75, 0.06)});
}

/// The blurred image of a lamp in a glossy floor.
Check mirrored_lamp(Generator& random) {
    const Place place = any_place(random);
    const double n = between(random, 8, 14), angle = between(random, 0.5, 0.8);
    const rt::Sphere shining{place({4 * std::sin(angle), 0, 4 * std::cos(angle)}), 0.9};
    const View view{
        place({-4 * std::sin(angle), 0, 4 * std::cos(angle)}), place({0, 0, 0}), place.turned({0, 0, 1}), 50, {24, 24}};
    const std::string scene = toml(view) + unsampled_lamp("lamp", 1) +
                              material("floor", {{"reflectance", 1}, {"exponent", n}}) +
                              sphere("lamp", shining.center, shining.radius) + place.floor("floor", 100);
    const vec3 up = place.axes.z;
    const LobeSurface floor{camera_of(scene), place.origin, up, [=](vec3 d, double exponent) {
                                return Lobe{d - 2 * rt::dot(d, up) * up, up, exponent, 1};
                            }};
    return render_check("lamp", {scene, 64, "sobol"}, blurred_lamp(floor, shining, n, "the mirror direction"));
}

Check rays(Generator& random, const std::string& name, double angle) {
    const double n = between(random, 6, 12);
    const vec3 normal = direction(random), d = -tilted(random, normal, angle);
    const vec3 axis = rt::unit(d - 2 * rt::dot(d, normal) * normal);
    const auto inputs = with_repeats(rows_over_square(32, [=](rt::vec2 u) { return row(d, normal, n, u); }));
    return probe_check(
        name, inputs,
        lobe_statistics({.axis = axis,
                         .outward = normal,
                         .exponent = n,
                         .lobe_about = "the mirror direction",
                         .suspects = {lobe_about("the lobe is about the normal; expected about the mirror direction",
                                                 normal, normal, n, (n + 2) / (n + 1))}}));
}

/// Any angle and exponent.
Check density_of_reflected() {
    const auto row_with = [](Generator& draw, rt::vec2 u) {
        const vec3 n = scene_direction(draw), d = -tilted(draw, n, between(draw, 0, 1));
        return row(d, n, log_between(draw, 0.1, 30), u);
    };
    return density_of_lobe(row_with, [](const Row& in) {
        const auto [d, n, exponent, u] = TypesOf<decltype(&rt::glossy_reflection)>::arguments(in);
        return LobeOf{d - 2 * rt::dot(d, n) * n, n, exponent};
    });
}

}  // namespace

Checks check_glossy_reflection(Generator& random) {
    const Check head_on = rays(random, "head_on", 0);
    const double angle = between(random, 0.9, 1.2);
    const Checks any_exponent =
        lobe_of_any_exponent(true, [](vec3 d, vec3 n, double exponent, rt::vec2 u) { return row(d, n, exponent, u); });
    const Checks of_rays =
        joined({head_on, rays(random, "at_an_angle", angle), rays(random, "grazing", between(random, 1.48, 1.54))},
               any_exponent);
    return joined(of_rays, {density_of_reflected(), ball(random), mirrored_lamp(random)});
}

}  // namespace grade
