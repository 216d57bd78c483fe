#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/fragment_checks.h"
#include "checks/kit/lobe_check.h"
#include "checks/kit/lobe_picture.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

/// A glossy ball where light comes from everywhere alike: seen at an angle, part of the lobe is below the surface.
Check ball(Generator& random) {
    const Place place = any_place(random);
    const double n = between(random, 6, 12), around = log_between(random, 0.3, 3);
    const rt::Color reflectance(between(random, 0.7, 1), between(random, 0.4, 0.6), between(random, 0.1, 0.3));
    const View view{place({0, 0, 10}), place({0, 0, 0}), place.turned({0, 1, 0}), 12, {48, 48}};
    const std::string scene =
        fmt::format("environment = {}\n\n{}[materials.steel]\nreflectance = {}\nexponent = {}\n\n", toml(around),
                    toml(view), toml(reflectance), toml(n)) +
        sphere("steel", place({0, 0, 0}), 1);
    const rt::Camera camera = rt::parse_scene(scene, "ball").camera;

    const auto albedo = tabulated_albedo(n);
    const auto angle_at = [=](rt::vec2 film) {  // from the normal
        const rt::vec3 beside = rt::cross(place.origin - camera.eye, view_direction(camera, film));
        const double sine = glm::length(beside);
        return sine < 1 ? std::asin(sine) : rt::pi;
    };
    const auto over_truth = [=](double low, double high) {
        return [=](const rt::Image& image) {
            double seen = 0, due = 0;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x) {
                    const double angle = angle_at({x + 0.5, y + 0.5}) * 180 / rt::pi;
                    if (angle < low || angle > high) continue;
                    seen += brightness(image.at(x, y) / reflectance);
                    due += over_pixel(x, y, [&](rt::vec2 film) { return albedo(angle_at(film)); });
                }
            return seen / due / around;
        };
    };
    const auto hint = [=](const std::string& where, double degrees) {
        return by_ratio(
            "what a glossy ball reflects " + where,
            {{(n + 1) / (n + 2), "does n + 1 stand for n + 2 in the BRDF?"},
             {(n + 2) / (n + 1), "is the cosine at the surface missing, or does (n + 2)/(n + 1) count twice?"},
             {1 / albedo(degrees * rt::pi / 180),
              "does the weight have the cosine at the surface, and is it 0 below the surface?"}},
            "expected (n + 2)/(2 pi) cos(alpha)^n x cosine at the surface / density, 0 below the surface");
    };
    return render_check("ball", {scene, 16, "sobol"},
                        {of_picture("P2", "light that it reflects where it is seen head on, over what must be",
                                    over_truth(0, 25), 1, 0.05, hint("where it is seen head on", 0)),
                         of_picture("P3", "light that it reflects where it is seen at 60 degrees, over what must be",
                                    over_truth(53, 65), 1, 0.05, hint("where it is seen at 60 degrees", 60)),
                         of_picture("P3", "light that it reflects near its rim, over what must be", over_truth(70, 78),
                                    1, 0.06, hint("near its rim", 75))});
}

/// The blurred image of a lamp in a glossy floor.
Check mirrored_lamp(Generator& random) {
    const Place place = any_place(random);
    const double n = between(random, 8, 14), angle = between(random, 0.5, 0.8);
    const rt::Sphere shining{place({4 * std::sin(angle), 0, 4 * std::cos(angle)}), 0.9};
    const View view{
        place({-4 * std::sin(angle), 0, 4 * std::cos(angle)}), place({0, 0, 0}), place.turned({0, 0, 1}), 50, {24, 24}};
    const std::string scene = fmt::format(
                                  "{}[materials.lamp]\nemission = 1\nsampled = false\n\n[materials.floor]\nreflectance "
                                  "= 1\nexponent = {}\n\n",
                                  toml(view), toml(n)) +
                              sphere("lamp", shining.center, shining.radius) +
                              quad("floor", place({0, 0, 0}), 100.0 * place.axes.x, 100.0 * place.axes.y);
    const rt::vec3 up = place.axes.z;
    const LobeSurface floor{rt::parse_scene(scene, "lamp").camera, place.origin, up, [=](rt::vec3 d, double exponent) {
        return Lobe{d - 2 * rt::dot(d, up) * up, up, exponent, 1};
    }};
    return render_check("lamp", {scene, 64, "sobol"}, blurred_lamp(floor, shining, n, "the mirror direction"));
}

}  // namespace

Checks check_glossy_reflection(Generator& random) {
    using rt::vec3;
    Checks checks;
    for (const char* name : {"head_on", "at_an_angle"}) {
        const double angle = checks.empty() ? 0 : between(random, 0.9, 1.2), n = between(random, 6, 12);
        const vec3 normal = direction(random), d = -tilted(random, normal, angle);
        const vec3 axis = rt::unit(d - 2 * rt::dot(d, normal) * normal);
        const auto inputs = [=](Generator& draws) {
            return repeat(rows_over_square(32, [=](rt::vec2 u) { return row(d, normal, n, u); })(draws));
        };
        checks.push_back(probe_check(
            name, inputs,
            lobe_statistics({axis,
                             normal,
                             n,
                             "the mirror direction",
                             {lobe_about("the lobe is about the normal; expected about the mirror direction", normal,
                                         normal, n, (n + 2) / (n + 1))}})));
    }
    checks.push_back(ball(random));
    checks.push_back(mirrored_lamp(random));
    return checks;
}

}  // namespace grade
