#include "stress/exact.h"
#include "stress/family.h"

namespace grade {

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

double error_of_shots(const Asker& ask, const std::vector<std::pair<Sphere, Ray>>& shots, double size) {
    Rows rows;
    for (const auto& [sphere, ray] : shots) rows.push_back(row(sphere, ray));
    return worst_of(ask, "hit_sphere", rows, [&](std::size_t i, const Row& out) {
        return error_of(out.at(0), shots[i].first, shots[i].second, size);
    });
}

/// Rays at spheres from so far away.
double far_sphere(double x, Generator& random, const Asker& ask) {
    double worst = 0;
    std::vector<Shot> shots;
    Rows rows;
    for (int i = 0; i < 200; ++i)
        shots.push_back(shot(random, 1.5 + x)), rows.push_back(row(shots.back().sphere, shots.back().ray));
    const Rows out = ask.probe("hit_sphere", rows);
    for (std::size_t i = 0; i < shots.size(); ++i)
        worst = worse_error(worst,
                            error_of(out[i].at(0), shots[i].sphere, shots[i].ray, (2.5 + x) * shots[i].sphere.radius));
    return worst;
}

/// A floor that is a huge sphere, seen by somebody who stands on it.
double ground_sphere(double x, Generator& random, const Asker& ask) {
    std::vector<std::pair<Sphere, Ray>> shots;
    const double radius = 10 * x, eye = 1.7;
    for (int i = 0; i < 200; ++i)
        shots.push_back({{{0, -radius, 0}, radius},
                         {{0, eye, 0}, tilted(random, {0, -1, 0}, between(random, 0, 1.2)), 0, rt::inf}});
    return error_of_shots(ask, shots, radius + eye);
}

/// Scene and ray as large as x; half of the rays start inside.
double sphere_scale(double x, Generator& random, const Asker& ask) {
    std::vector<std::pair<Sphere, Ray>> shots;
    for (int i = 0; i < 200; ++i) {
        const Shot s = i % 2 ? shot(random, between(random, 2, 5)) : shot(random, 0, 0, 0.8);
        shots.push_back({{x * s.sphere.center, x * s.sphere.radius}, {x * s.ray.origin, s.ray.direction, 0, rt::inf}});
    }
    return error_of_shots(ask, shots, 5 * x);
}

/// Directions as long as x.
double sphere_direction(double x, Generator& random, const Asker& ask) {
    std::vector<std::pair<Sphere, Ray>> shots;
    for (int i = 0; i < 200; ++i) {
        const Shot s = shot(random, between(random, 2, 5));
        shots.push_back({s.sphere, {s.ray.origin, x * s.ray.direction, 0, rt::inf}});
    }
    return error_of_shots(ask, shots, 5);
}

/// Sphere and ray so far from the world's origin.
double sphere_offset(double x, Generator& random, const Asker& ask) {
    std::vector<std::pair<Sphere, Ray>> shots;
    for (int i = 0; i < 200; ++i) {
        Shot s = shot(random, between(random, 2, 5));
        const vec3 offset = x * vec3(0.6, -0.7, 0.3);
        shots.push_back(
            {{s.sphere.center + offset, s.sphere.radius}, {s.ray.origin + offset, s.ray.direction, 0, rt::inf}});
        // as rounding has moved both, some rays pass nearer to the rim
        const Exact3 f = Exact3(shots.back().second.origin) - Exact3(shots.back().first.center), d(s.ray.direction);
        const double passing = double(length(f - dot(f, d) / dot(d, d) * d)) / s.sphere.radius;
        if (std::abs(passing - 1) < 0.05) shots.pop_back();
    }
    return error_of_shots(ask, shots, 5);
}

/// Rays that miss the rim by so little, outside or inside.
double sphere_rim(double x, Generator& random, const Asker& ask) {
    Rows rows;
    std::vector<bool> hits;
    for (int i = 0; i < 400; ++i) {
        const bool hit = i % 2;
        const Sphere sphere{vec3(0), log_between(random, 0.5, 2)};
        const vec3 d = direction(random),
                   beside = sphere.radius * (hit ? 1 - x : 1 + x) * tilted(random, d, rt::pi / 2);
        const Ray ray{beside - between(random, 2, 4) * sphere.radius * d, d, 0, rt::inf};
        rows.push_back(row(sphere, ray)), hits.push_back(hit);
    }
    return worst_of(ask, "hit_sphere", rows, [&](std::size_t i, const Row& out) {
        return std::isnan(out.at(0)) || std::isfinite(out[0]) != hits[i] ? rt::inf : 0;
    });
}

}  // namespace

std::vector<Family> sphere_families() {
    constexpr double u = rt::roundoff;
    return {
        {"far_sphere",
         {"hit_sphere"},
         "distance of a sphere / its radius",
         "error of the hit / distance",
         1e-7,
         16 * u,
         sweep(0, 12),
         {0, 3},
         far_sphere},
        {"ground_sphere",
         {"hit_sphere"},
         "radius of the ground [10 m]",
         "error of the hit / radius",
         1e-7,
         16 * u,
         sweep(0, 12),
         {0, 2},
         ground_sphere},
        {"sphere_scale",
         {"hit_sphere"},
         "size of sphere and ray [m]",
         "error of the hit / size",
         1e-7,
         64 * u,
         sweep(-60, 60, 3),
         {-3, 3},
         sphere_scale},
        {"sphere_direction",
         {"hit_sphere"},
         "length of the direction",
         "error of the hit",
         1e-7,
         64 * u,
         sweep(-12, 12),
         {-3, 3},
         sphere_direction},
        {"sphere_offset",
         {"hit_sphere"},
         "distance from the world's origin [m]",
         "error of the hit",
         1e-7,
         64 * u,
         sweep(0, 12),
         {0, 3},
         sphere_offset},
        {"sphere_rim",
         {"hit_sphere"},
         "distance of a ray from the rim / radius",
         "wrong verdicts",
         0,
         0,
         sweep(-13, -1),
         {-3, -1},
         sphere_rim},
    };
}

}  // namespace grade
