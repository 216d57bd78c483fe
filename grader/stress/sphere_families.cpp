#include "asked/hit_sphere.h"
#include "stress/exact.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::Ray, rt::Sphere, rt::vec3;

/// The first crossing in front of the ray, in units of |direction|; none: inf.
double first_crossing(const Sphere& sphere, const Ray& ray) {
    const Exact3 f = Exact3(ray.origin) - Exact3(sphere.center), d(ray.direction);
    const Exact a = dot(d, d), b = -dot(f, d), c = dot(f, f) - Exact(sphere.radius) * sphere.radius;
    const Exact discriminant = b * b - a * c;
    if (discriminant < 0) return rt::inf;
    const Exact root = sqrt(discriminant), first = (b - root) / a, last = (b + root) / a;
    return first > 0 ? double(first) : last > 0 ? double(last) : rt::inf;
}

/// A sphere with a ray towards a point beside its centre, at so many radii from it; not near the rim.
struct Shot {
    Sphere sphere;
    Ray ray;
    double passing;  // distance of the ray's line from the centre [radius]
};

Shot shot(Generator& random, double distance, double low = 0, double high = 2) {
    Shot s;
    s.sphere = {box(random, -1, 1), log_between(random, 0.5, 2)};
    const vec3 d = direction(random);
    do s.passing = between(random, low, high);
    while (std::abs(s.passing - 1) < 0.1);
    const vec3 beside = s.passing * s.sphere.radius * tilted(random, d, rt::pi / 2);
    s.ray = {s.sphere.center + beside - distance * s.sphere.radius * d, d, 0, rt::inf};
    return s;
}

/// |t - truth| |d| over the length that the rounding of the ray's numbers is in proportion to; inf: a wrong verdict.
double error_of(double t, const Sphere& sphere, const Ray& ray, double size) {
    const double truth = first_crossing(sphere, ray);
    if (std::isfinite(t) != std::isfinite(truth) || std::isnan(t)) return rt::inf;
    return std::isfinite(t) ? std::abs(t - truth) * glm::length(ray.direction) / size : 0;
}

double error_of_shots(const Rows& rows, double size, const Asker& ask) {
    return worst_of<rt::hit_sphere>(ask, "hit_sphere", rows, [=](double t, const Sphere& sphere, const Ray& ray) {
        return error_of(t, sphere, ray, size);
    });
}

/// Rays at spheres from so far away.
double far_sphere(double x, Generator& random, const Asker& ask) {
    const Rows rows = rows_of(200, [=](Generator& draw) {
        const Shot s = shot(draw, 1.5 + x);
        return row(s.sphere, s.ray);
    })(random);
    return worst_of<rt::hit_sphere>(ask, "hit_sphere", rows, [=](double t, const Sphere& sphere, const Ray& ray) {
        return error_of(t, sphere, ray, (2.5 + x) * sphere.radius);
    });
}

/// A floor that is a huge sphere, seen by somebody who stands on it.
double ground_sphere(double x, Generator& random, const Asker& ask) {
    const double radius = 10 * x, eye = 1.7;
    const Rows rows = rows_of(200, [=](Generator& draw) {
        const Ray down{{0, eye, 0}, tilted(draw, {0, -1, 0}, between(draw, 0, 1.2)), 0, rt::inf};
        return row(Sphere{{0, -radius, 0}, radius}, down);
    })(random);
    return error_of_shots(rows, radius + eye, ask);
}

/// Scene and ray as large as x; half of the rays start inside.
double sphere_scale(double x, Generator& random, const Asker& ask) {
    Rows rows;
    for (int i = 0; i < 200; ++i) {
        const Shot s = i % 2 ? shot(random, between(random, 2, 5)) : shot(random, 0, 0, 0.8);
        const Sphere sphere{x * s.sphere.center, x * s.sphere.radius};
        rows.push_back(row(sphere, Ray{x * s.ray.origin, s.ray.direction, 0, rt::inf}));
    }
    return error_of_shots(rows, 5 * x, ask);
}

/// Directions as long as x.
double sphere_direction(double x, Generator& random, const Asker& ask) {
    const Rows rows = rows_of(200, [=](Generator& draw) {
        const Shot s = shot(draw, between(draw, 2, 5));
        return row(s.sphere, Ray{s.ray.origin, x * s.ray.direction, 0, rt::inf});
    })(random);
    return error_of_shots(rows, 5, ask);
}

/// Sphere and ray so far from the world's origin.
double sphere_offset(double x, Generator& random, const Asker& ask) {
    const vec3 offset = x * vec3(0.6, -0.7, 0.3);
    Rows rows;
    for (int i = 0; i < 200; ++i) {
        const Shot s = shot(random, between(random, 2, 5));
        const Sphere sphere{s.sphere.center + offset, s.sphere.radius};
        const Ray ray{s.ray.origin + offset, s.ray.direction, 0, rt::inf};
        // as rounding has moved both, some rays pass nearer to the rim
        const Exact3 f = Exact3(ray.origin) - Exact3(sphere.center), d(ray.direction);
        const double passing = double(length(f - dot(f, d) / dot(d, d) * d)) / sphere.radius;
        if (!(std::abs(passing - 1) < 0.05)) rows.push_back(row(sphere, ray));
    }
    return error_of_shots(rows, 5, ask);
}

/// Rays that miss the rim by so little, outside or inside.
double sphere_rim(double x, Generator& random, const Asker& ask) {
    Rows rows;
    for (int i = 0; i < 400; ++i) {
        const Sphere sphere{vec3(0), log_between(random, 0.5, 2)};
        const vec3 d = direction(random),
                   beside = sphere.radius * (i % 2 ? 1 - x : 1 + x) * tilted(random, d, rt::pi / 2);
        rows.push_back(row(sphere, Ray{beside - between(random, 2, 4) * sphere.radius * d, d, 0, rt::inf}));
    }
    const Rows out = ask.probe("hit_sphere", rows);
    for (std::size_t i = 0; i < out.size(); ++i)
        if (std::isnan(out[i].at(0)) || std::isfinite(out[i][0]) != (i % 2 == 1)) return rt::inf;
    return 0;
}

}  // namespace

std::vector<Family> sphere_families() {
    constexpr double u = rt::roundoff;
    return {Family("far_sphere", {"hit_sphere"}, "distance of a sphere / its radius", "error of the hit / distance",
                   {.tolerance = 1e-7, .bound = 16 * u, .decades = sweep(0, 12), .scored = {0, 3}}, far_sphere),
            Family("ground_sphere", {"hit_sphere"}, "radius of the ground [10 m]", "error of the hit / radius",
                   {.tolerance = 1e-7, .bound = 16 * u, .decades = sweep(0, 12), .scored = {0, 2}}, ground_sphere),
            Family("sphere_scale", {"hit_sphere"}, "size of sphere and ray [m]", "error of the hit / size",
                   {.tolerance = 1e-7, .bound = 64 * u, .decades = sweep(-60, 60, 3)}, sphere_scale),
            Family("sphere_direction", {"hit_sphere"}, "length of the direction", "error of the hit",
                   {.tolerance = 1e-7, .bound = 64 * u, .decades = sweep(-12, 12)}, sphere_direction),
            Family("sphere_offset", {"hit_sphere"}, "distance from the world's origin [m]", "error of the hit",
                   {.tolerance = 1e-7, .bound = 64 * u, .decades = sweep(0, 12), .scored = {0, 3}}, sphere_offset),
            Family("sphere_rim", {"hit_sphere"}, "distance of a ray from the rim / radius", "wrong verdicts",
                   {.tolerance = 0, .decades = sweep(-13, -1), .scored = {-3, -1}}, sphere_rim)};
}

}  // namespace grade::stress
