#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/render_check.h"
#include "statistics/blob.h"

namespace grade {

namespace {

using rt::vec2, rt::vec3;

Check points() {
    const auto inputs = rows_of(64, [](Generator& random) {
        const vec3 point = box(random, -5, 5), velocity = chance(random, 0.1) ? vec3(0) : box(random, -3, 3);
        const double time = chance(random, 0.1) ? 0 : between(random, -2, 4);
        return row(point, velocity, time);
    });
    const auto at = [](auto f) {
        return of<vec3, vec3, double>(
            [=](vec3 point, vec3 velocity, double time) { return vec3(f(point, velocity, time)); });
    };
    return probe_check(
        "points", inputs,
        {formula(
            "M1", "point, off by", at([](vec3 p, vec3 v, double t) { return p + t * v; }), 1e-5,
            {{"the point does not move", at([](vec3 p, vec3, double) { return p; })},
             {"the time is not used: the point is always where it is after 1 s",
              at([](vec3 p, vec3 v, double) { return p + v; })},
             {"the point moves backwards", at([](vec3 p, vec3 v, double t) { return p - t * v; })},
             {"only the way is returned; expected the point after it",
              at([](vec3, vec3 v, double t) { return t * v; })},
             {"the speed is not used, the direction of the velocity alone",
              at([](vec3 p, vec3 v, double t) { return p + t * rt::unit(v); })},
             {"only the x component moves", at([](vec3 p, vec3 v, double t) { return p + t * vec3(v.x, 0, 0); })},
             {"the z component does not move", at([](vec3 p, vec3 v, double t) { return p + t * vec3(v.x, v.y, 0); })},
             {"times before 0 are clamped: a point moves then too",
              at([](vec3 p, vec3 v, double t) { return p + std::max(t, 0.0) * v; })},
             {"the way grows with the square of the time", at([](vec3 p, vec3 v, double t) { return p + t * t * v; })},
             {"half of the way is gone", at([](vec3 p, vec3 v, double t) { return p + 0.5 * t * v; })},
             {"twice the way is gone", at([](vec3 p, vec3 v, double t) { return p + 2.0 * t * v; })}})});
}

/// Where something is in the picture, along its motion and across, from where it must be.
std::vector<Statistic> places(const std::string& id, const std::string& thing,
                              std::function<vec2(const rt::Image&)> centroid, vec2 due, vec2 step, double time) {
    const double speed = std::hypot(step.x, step.y);
    const vec2 along = step / speed, across(-along.y, along.x);
    const auto off = [=](vec2 axis) {
        return [=](const rt::Image& image) {
            const vec2 d = centroid(image) - due;
            return d.x * axis.x + d.y * axis.y;
        };
    };
    return {of_picture(id, thing + ": distance along its way from where it must be [pixel]", off(along), 0, 0.5,
                       by_value(thing + ": its distance along its way from where it must be",
                                {{-speed * time, "it stands still"},
                                 {-2 * speed * time, "it moves backwards"},
                                 {speed * (1 - time), "it is always where it is after 1 s"}},
                                0.8)),
            of_picture(id, thing + ": distance from its way [pixel]", off(across), 0, 0.5,
                       always(thing + " has left its way: point + time x velocity"))};
}

/// A lamp that flies by, and the shadow that a disc behind the camera throws on the floor below, at one instant. They
/// are on black and on white, in two pictures: the shutter is open so shortly that any time is the same.
Check moving_lamp(Generator& random) {
    const Place place = any_place(random);
    const double time = between(random, 0.4, 0.7) * (chance(random, 0.5) ? 1 : -1),
                 turn = between(random, 0, 2 * rt::pi);
    constexpr double pixel = 0.01;  // [m] across the plane of the lamp
    const vec2 step = 16.0 * vec2(std::cos(turn), std::sin(turn));  // [pixel/s], y up
    const vec2 start = vec2(between(random, -3, 3), between(random, -3, 3)) - time * step;
    const View view{place({0, 0, 5}),
                    place({0, 0, 0}),
                    place.turned({0, 1, 0}),
                    2 * std::atan(16 * pixel / 5) * 180 / rt::pi,
                    {32, 32}};
    const std::string scene =
        fmt::format("{}[shutter]\nopen = {}\nclose = {}\n\n[materials.lamp]\nemission = 2\nsampled = false\n\n",
                    toml(view), toml(time), toml(time + 1e-9)) +
        sphere("lamp", place(pixel * vec3(start.x, start.y, 0)), 4 * pixel,
               place.turned(pixel * vec3(step.x, step.y, 0)));
    const vec2 due = start + time * step;
    return render_check("lamp", {scene, 16, "sobol"},
                        places(
                            "M1", "a lamp that flies by",
                            [](const rt::Image& image) { return blob_moments(image, whole(image)).centroid; },
                            {16 + due.x, 16 - due.y}, {step.x, -step.y}, time));
}

Check shadow(Generator& random) {
    const Place place = any_place(random);
    const double time = between(random, 0.4, 0.7) * (chance(random, 0.5) ? 1 : -1),
                 turn = between(random, 0, 2 * rt::pi);
    constexpr double pixel = 0.01;
    const vec2 step = 16.0 * vec2(std::cos(turn), std::sin(turn));
    const vec2 start = vec2(between(random, -3, 3), between(random, -3, 3)) - time * step;
    const vec3 toward = {between(random, -0.3, 0.3), between(random, -0.3, 0.3), 1};
    const View view{place({0, 0, 5}),
                    place({0, 0, 0}),
                    place.turned({0, 1, 0}),
                    2 * std::atan(16 * pixel / 5) * 180 / rt::pi,
                    {32, 32}};
    const std::string scene =
        fmt::format("{}[shutter]\nopen = {}\nclose = {}\n\n[materials.floor]\nalbedo = 0.8\n\n[materials.card]\n\n",
                    toml(view), toml(time), toml(time + 1e-9)) +
        fmt::format("[[light]]\ntype = \"directional\"\ntoward = {}\nirradiance = 3\n\n", toml(place.turned(toward))) +
        quad("floor", place({0, 0, 0}), place.axes.x, place.axes.y) +
        // as high as the light's slope needs; behind the camera, which does not see it
        disc("card", place(pixel * vec3(start.x, start.y, 0) + 6.0 * toward), place.axes.z, 5 * pixel,
             place.turned(pixel * vec3(step.x, step.y, 0)));
    const vec2 due = start + time * step;
    const auto centroid = [](const rt::Image& image) {
        rt::Image darkness = image;
        double lit = 0;
        for (const rt::Color& p : image.pixels) lit = std::max(lit, p.r);
        for (rt::Color& p : darkness.pixels) p = rt::Color(lit - p.r);
        return blob_moments(darkness, whole(darkness)).centroid;
    };
    return render_check("shadow", {scene, 16, "sobol"},
                        places("M3", "the shadow of a card that flies by", centroid, {16 + due.x, 16 - due.y},
                               {step.x, -step.y}, time));
}

/// A lamp that flies by behind the camera, which sees it in a mirror.
Check reflection(Generator& random) {
    const Place place = any_place(random);
    const double time = between(random, 0.4, 0.7) * (chance(random, 0.5) ? 1 : -1),
                 turn = between(random, 0, 2 * rt::pi);
    constexpr double eye = 3, height = 5,
                     pixel = 0.01;  // [m]: of the camera and the lamp before the mirror; across the lamp's plane
    const vec2 step = 16.0 * vec2(std::cos(turn), std::sin(turn));
    const vec2 start = vec2(between(random, -3, 3), between(random, -3, 3)) - time * step;
    const double vfov =
        2 * std::atan(16 * pixel / (eye + height)) * 180 / rt::pi;  // the image stands behind the mirror
    const View view{place({0, 0, eye}), place({0, 0, 0}), place.turned({0, 1, 0}), vfov, {32, 32}};
    const std::string scene =
        fmt::format(
            "{}[shutter]\nopen = {}\nclose = {}\n\n[materials.lamp]\nemission = 2\nsampled = false\n\n"
            "[materials.mirror]\nreflectance = 1\n\n",
            toml(view), toml(time), toml(time + 1e-9)) +
        quad("mirror", place({0, 0, 0}), place.axes.x, place.axes.y) +
        sphere("lamp", place({pixel * start.x, pixel * start.y, height}), 4 * pixel,
               place.turned(pixel * vec3(step.x, step.y, 0)));
    const vec2 due = start + time * step;
    return render_check("reflection", {scene, 16, "sobol"},
                        places(
                            "M3", "the mirror image of a lamp that flies by",
                            [](const rt::Image& image) { return blob_moments(image, whole(image)).centroid; },
                            {16 + due.x, 16 - due.y}, {step.x, -step.y}, time));
}

}  // namespace

Checks check_moved(Generator& random) { return {points(), moving_lamp(random), shadow(random), reflection(random)}; }

}  // namespace grade
