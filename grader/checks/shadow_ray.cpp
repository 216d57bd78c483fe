#include <algorithm>

#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/shadow_scene.h"

namespace grade {

namespace {

using rt::Hit, rt::Ray, rt::vec3;

struct Arguments {
    Hit hit;
    vec3 to_light;
    double distance;
};

Arguments arguments_of(const Row& in) {
    RowReader reader(in);
    const Hit hit = read(reader, Tag<Hit>{});
    const vec3 to_light = read(reader, Tag<vec3>{});
    return {hit, to_light, reader.number()};
}

/// The point of a ray at a parameter, as a distance from the surface point along the way to the light.
double along(const Arguments& a, const Ray& ray, double t) {
    return rt::dot(ray.origin + t * ray.direction - a.hit.point, a.to_light);
}

Statistic about_ray(std::string what, std::function<double(const Arguments&, const Ray&)> violation, double tolerance,
                    std::string hint) {
    return property(
        "L4", std::move(what),
        [=](const Row& in, const Row& out) { return violation(arguments_of(in), from_row<Ray>(out)); }, tolerance,
        std::move(hint));
}

}  // namespace

Checks check_shadow_ray(Generator& random) {
    const auto inputs = rows_of(64, [](Generator& draw) {
        const vec3 point = box(draw, -5, 5), n = direction(draw);
        const double distance = chance(draw, 0.2) ? rt::inf : log_between(draw, 0.5, 50);
        return row(Hit{point, n, 1e-14 * (1 + rt::largest(point))}, tilted(draw, n, between(draw, 0, 1.4)), distance);
    });
    // ordinary scenes are some metres wide: plain code with an epsilon of a millimetre passes
    const double small = 2e-3;
    Statistic aim = about_ray(
        "angle off the light [rad]",
        [](const Arguments& a, const Ray& r) {
            return glm::length(rt::cross(rt::unit(r.direction), a.to_light)) +
                   (rt::dot(r.direction, a.to_light) > 0 ? 0 : 1);
        },
        1e-3, "the ray does not run towards the light");
    Statistic start = about_ray(
        "start of the ray, away from the surface point by [m]",
        [](const Arguments& a, const Ray& r) {
            return std::abs(along(a, r, r.near)) + glm::length(r.origin - a.hit.point);
        },
        2 * small,
        "the ray's origin is too far from the surface, so shadows come loose from what casts them: is an epsilon too "
        "large?");
    Statistic clear = about_ray("start of the ray on or below the surface",
        [](const Arguments& a, const Ray& r) {
            const double height = rt::dot(r.origin + r.near * r.direction - a.hit.point, a.hit.normal);
            return height >= 0.5 * a.hit.error ? 0.0 : 1.0;
        },
        0, "the ray can meet the surface where it starts (acne): spawn_ray moves the origin off it");
    Statistic inside = about_ray(
        "start of the ray below the surface",
        [](const Arguments& a, const Ray& r) {
            return rt::dot(r.origin + r.near * r.direction - a.hit.point, a.hit.normal) < -0.5 * a.hit.error ? 1.0
                                                                                                             : 0.0;
        },
        0, "the ray starts on the wrong side, inside the surface: it must leave on the side to which it points");
    Statistic beyond = about_ray("end of the ray, beyond the light by [share of the distance]",
        [](const Arguments& a, const Ray& r) {
            if (std::isinf(a.distance)) return 0.0;
            return std::clamp(along(a, r, r.far) / a.distance - (1 - 1e-12), 0.0, 1.0);
        },
        0, "the ray is not bounded by the light: what is behind the light, or the light itself, casts a shadow");
    Statistic before = about_ray(
        "end of the ray, short of the light by [share of the distance]",
        [](const Arguments& a, const Ray& r) {
            if (std::isinf(a.distance)) return r.far > 1e6 ? 0.0 : 1.0;
            return std::max(0.0, 1 - along(a, r, r.far) / a.distance);
        },
        2 * small,
        "the ray ends too far before the light: what is near the light casts no shadow; is its far end in units of its "
        "direction?");
    return {probe_check("from_surface_to_light", inputs, {aim, inside, clear, start, before, beyond}),
            shadow_check(random, "hard_shadow", any_shadow(random, std::nullopt))};
}

}  // namespace grade
