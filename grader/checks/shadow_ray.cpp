#include "asked/shadow_ray.h"
#include "checks/kit/kit.h"
#include "checks/kit/shadow_scene.h"

namespace grade {

namespace {

using rt::Hit, rt::Ray, rt::vec3;

/// The point of a ray at a parameter, as a distance from the surface point along the way to the light.
double along(const Ray& ray, double t, const Hit& hit, vec3 to_light) {
    return rt::dot(ray.origin + t * ray.direction - hit.point, to_light);
}

/// How high above the surface a ray starts.
double height_of_start(const Ray& ray, const Hit& hit) {
    return rt::dot(ray.origin + ray.near * ray.direction - hit.point, hit.normal);
}

/// violation(ray, hit, to_light, distance)
template <class Violation>
Statistic about_ray(const std::string& what, Violation violation, double tolerance, const std::string& says) {
    return property({.id = "L4",
                     .what = what,
                     .violation = of_call<rt::shadow_ray>(violation),
                     .tolerance = tolerance,
                     .says = says});
}

/// Ordinary scenes are some metres wide: plain code with an epsilon of a millimetre passes.
constexpr double small = 2e-3;

/// Where the ray starts, and where it runs.
std::vector<Statistic> begin_of_ray() {
    const Statistic aim = about_ray(
        "angle off the light [rad]",
        [](const Ray& r, const Hit&, vec3 to_light, double) {
            const double sine = glm::length(rt::cross(rt::unit(r.direction), to_light));
            return sine + (rt::dot(r.direction, to_light) > 0 ? 0 : 1);
        },
        1e-3, "the ray does not run towards the light");
    const Statistic start = about_ray(
        "start of the ray, away from the surface point by [m]",
        [](const Ray& r, const Hit& hit, vec3 to_light, double) {
            return std::abs(along(r, r.near, hit, to_light)) + glm::length(r.origin - hit.point);
        },
        2 * small,
        "the ray's origin is too far from the surface, so shadows come loose from what casts them: is an epsilon too "
        "large?");
    const Statistic clear = about_ray(
        "start of the ray on or below the surface",
        [](const Ray& r, const Hit& hit, vec3, double) {
            return height_of_start(r, hit) >= 0.5 * hit.error ? 0.0 : 1.0;
        },
        0, "the ray can meet the surface where it starts (acne): spawn_ray moves the origin off it");
    const Statistic inside = about_ray(
        "start of the ray below the surface",
        [](const Ray& r, const Hit& hit, vec3, double) {
            return height_of_start(r, hit) < -0.5 * hit.error ? 1.0 : 0.0;
        },
        0, "the ray starts on the wrong side, inside the surface: it must leave on the side to which it points");
    return {aim, inside, clear, start};
}

/// Where it ends.
std::vector<Statistic> end_of_ray() {
    // how far the ray's end is beyond the light, as a share of the distance
    const auto over = [](const Ray& r, const Hit& hit, vec3 to_light, double distance) {
        return std::isinf(distance) ? -1 : along(r, r.far, hit, to_light) / distance - 1;
    };
    const Statistic beyond = property(
        {.id = "L4",
         .what = "end of the ray, beyond the light by [share of the distance]",
         .violation = of_call<rt::shadow_ray>([=](const Ray& r, const Hit& hit, vec3 to_light, double distance) {
             return std::clamp(over(r, hit, to_light, distance) + 1e-12, 0.0, 1.0);
         }),
         .says = "the ray is not bounded by the light: what is behind the light, or the light itself, casts a shadow",
         .mistakes = {
             {"the ray ends at the light and can meet the light itself: its far end is distance * short_of_light",
              of_call<rt::shadow_ray>([=](const Ray& r, const Hit& hit, vec3 to_light, double distance) {
                  return over(r, hit, to_light, distance) < 1e-9 ? 0.0 : 1.0;
              })}}});
    const Statistic before = about_ray(
        "end of the ray, short of the light by [share of the distance]",
        [](const Ray& r, const Hit& hit, vec3 to_light, double distance) {
            if (std::isinf(distance)) return r.far > 1e6 ? 0.0 : 1.0;
            return std::max(0.0, 1 - along(r, r.far, hit, to_light) / distance);
        },
        2 * small,
        "the ray ends too far before the light: what is near the light casts no shadow; is its far end in units of its "
        "direction?");
    return {beyond, before};
}

}  // namespace

Checks check_shadow_ray(Generator& random) {
    const auto inputs = rows_of(96, [](Generator& draw) {
        const vec3 point = box(draw, -5, 5), n = scene_direction(draw);
        // not along the normal: there an origin off the surface brings the far end as close to the light as it was
        // moved
        const double distance = chance(draw, 0.2) ? rt::inf : log_between(draw, 0.5, 50);
        return row(Hit{point, n, 1e-14 * (1 + rt::largest(point))}, tilted(draw, n, between(draw, 0.1, 1.4)), distance);
    });
    return {probe_check("from_surface_to_light", inputs, joined(begin_of_ray(), end_of_ray())),
            shadow_check(random, "hard_shadow", any_shadow(random, std::nullopt))};
}

}  // namespace grade
