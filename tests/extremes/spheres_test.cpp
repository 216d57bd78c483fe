/// Spheres that are far away, huge, grazed or nested: extremes.md 11, 12, 14 to 16, 24, 30.

#include <algorithm>

#include "extremes/extremes.h"
#include "rt/fragments.h"

using namespace rt;

namespace {

/// By how much a hit point is off the sphere.
long double off(const Sphere& s, const Ray& ray, Real t) {
    const Long p = Long(ray.origin) + (long double)(t)*Long(ray.direction);
    return std::abs(exact_length(p - Long(s.center)) - s.radius);
}

/// The distance of the centre from the ray's line.
long double miss_distance(const Sphere& s, const Ray& ray) {
    const Long f = Long(s.center) - Long(ray.origin), d = Long(ray.direction);
    return exact_length(f - exact_dot(f, d) / exact_dot(d, d) * d);
}

}  // namespace

TEST_CASE("11 a unit sphere from 1e3 to 1e12 away: the point is on it to 8u(d + r)", "[extremes]") {
    Random random(11);
    for (const Real decade : {1e3, 1e6, 1e9, 1e12}) {
        Greatest worst;
        for (int k = 0; k < 200000; ++k) {
            const Sphere sphere{vec3(0), 1};
            const vec3 eye = random.vector(decade, 10 * std::min(decade, 1e11));
            const Ray ray{eye, unit(random.number() * 0.8 * random.direction() - eye), 0, inf};
            if (miss_distance(sphere, ray) > 0.9L) continue;  // grazes: the direction's own rounding is 1e-4 at 1e12
            const Real t = hit_sphere(sphere, ray);
            const Real distance = std::sqrt(dot(eye, eye));
            worst.see(t < inf ? double(off(sphere, ray, t)) / (roundoff * (distance + 1)) : inf);
        }
        figure(11, "unit sphere seen from " + std::to_string(int(std::log10(decade))) + " decades away, in u(d + r)",
               worst.value, 8);
    }
}

TEST_CASE("12 a ground sphere of radius 1e8 from 1.7 above, and less", "[extremes]") {
    Random random(12);
    Greatest worst;
    for (int k = 0; k < 100000; ++k) {
        const Real height = k % 2 ? 1.7 : random.scale(1e-3, 1e3);
        const Sphere ground{{0, -1e8, 0}, 1e8};
        const Real t = hit_sphere(ground, {{0, height, 0}, {0, -1, 0}, 0, inf});
        worst.see(std::abs(t - height) / (roundoff * 1e8));
        const Frame frame = frame_about(unit(random.in_cube()));
        const Sphere tilted{-1e8 * frame.z, 1e8};
        const Ray ray{height * frame.z, -frame.z, 0, inf};
        const Real slanted = hit_sphere(tilted, ray);
        worst.see(slanted < inf ? double(off(tilted, ray, slanted)) / (roundoff * 1e8) : inf);
    }
    figure(12, "distance to a ground sphere of radius 1e8, in u r", worst.value, 8);
}

TEST_CASE("14 a sphere passed at r(1 +- 10^-k): the right verdict beyond 8ud, never a NaN", "[extremes]") {
    Random random(14);
    Greatest wrong;  // distance of the line from the rim at a wrong verdict, in u d
    std::int64_t nans = 0;
    for (int k = 1; k <= 15; ++k)
        for (int round = 0; round < 40000; ++round) {
            const Frame frame = frame_about(random.direction());
            const Sphere sphere{random.vector(0.1, 10), random.scale(0.01, 100)};
            const Real distance = sphere.radius * random.scale(1.1, 1e6),
                       share = 1 + (round % 2 ? 1 : -1) * std::pow(10.0, -k);
            const vec3 eye = sphere.center + share * sphere.radius * frame.x - distance * frame.z;
            const Ray ray{eye, random.scale(1e-3, 1e3) * frame.z, 0, inf};
            const Real t = hit_sphere(sphere, ray);
            nans += t != t;
            const long double apart = miss_distance(sphere, ray) - sphere.radius;
            if ((t < inf) == (apart < 0)) continue;
            wrong.see(double(std::abs(apart) / (exact_length(Long(eye) - Long(sphere.center)) * roundoff)));
        }
    CHECK(nans == 0);
    figure(14, "farthest from a sphere's rim with the wrong verdict, in u d", wrong.value, 8);
}

TEST_CASE("15 a tangent at its point of contact: both roots are 0", "[extremes]") {
    const Sphere sphere{{0, 0, 0}, 1};
    const Ray tangent{{0, 0, 1}, {1, 0, 0}, -1, inf};
    CHECK(hit_sphere(sphere, tangent) == 0);
    CHECK(hit_sphere(sphere, {tangent.origin, tangent.direction, 0, inf}) == inf);
    CHECK(hit_sphere(sphere, {tangent.origin, tangent.direction, -1, 0}) == inf);
}

TEST_CASE("16 from a sphere's centre the radius, in any direction", "[extremes]") {
    Random random(16);
    Greatest worst;
    for (int k = 0; k < 100000; ++k) {
        const Sphere sphere{random.vector(1e-6, 1e6), random.scale(1e-9, 1e9)};
        const vec3 d = random.vector(1e-12, 1e12);
        const Real t = hit_sphere(sphere, {sphere.center, d, 0, inf});
        worst.see(std::abs(t * std::sqrt(dot(d, d)) / sphere.radius - 1) / roundoff);
    }
    figure(16, "radius seen from the centre of a sphere, relative, in u", worst.value, 8);
}

TEST_CASE("24 directions from 1e-12 to 1e12 long: the same point", "[extremes]") {
    Random random(24);
    Greatest of_sphere, of_triangle, of_quad;
    const auto bits_equal = [](Real a, Real b) { return a == b ? 0.0 : inf; };
    Greatest powers;
    for (int k = 0; k < 100000; ++k) {
        const vec3 target = 0.3 * random.in_cube(), eye = random.vector(2, 100), d = unit(target - eye);
        const Real length = random.scale(1e-12, 1e12), exact = power_of_two(random.integer(-40, 40));
        const Frame frame = frame_about(unit(eye));
        const Triangle triangle{3.0 * frame.x, -2.0 * frame.x + 3.0 * frame.y, -2.0 * frame.x - 3.0 * frame.y};
        const Quad quad{vec3(0), frame.x, frame.y};
        const auto compare = [&](auto hit, const auto& shape, Greatest& worst) {
            const Real one = hit(shape, {eye, d, 0, inf}), t = hit(shape, {eye, length * d, 0, inf});
            const vec3 used = length * d;
            worst.see(std::abs(t * std::sqrt(dot(used, used)) / one - 1) / roundoff);
            powers.see(bits_equal(hit(shape, {eye, exact * d, 0, inf}) * exact, one));
        };
        compare(hit_sphere, Sphere{vec3(0), 1}, of_sphere);
        compare(hit_triangle, triangle, of_triangle);
        compare(hit_quad, quad, of_quad);
    }
    figure(24, "sphere: t |d| for |d| from 1e-12 to 1e12, relative, in u", of_sphere.value, 8);
    figure(24, "triangle: likewise, seen from the front", of_triangle.value, 8);
    figure(24, "quad: likewise", of_quad.value, 8);
    figure(24, "for |d| a power of two, bitwise", powers.value, 0);
}

TEST_CASE("30 spheres nested at 2^-i: from outside the outermost, from the middle the innermost", "[extremes]") {
    Random random(30);
    Scene scene = plain_scene();
    for (int i = 0; i < 20; ++i) scene.shapes.push_back({Sphere{vec3(0), power_of_two(-i)}, 0, vec3(0)});
    for (int k = 0; k < 1000; ++k) {
        const vec3 eye = random.vector(1.5, 1e3), d = unit(-eye);
        Real before = 0;
        for (const Shape& shape : scene.shapes) {
            const Real t = hit_sphere(std::get<Sphere>(shape.geometry), {eye, d, 0, inf});
            CHECK(t > before);
            CHECK(t < inf);
            before = t;
        }
        before = inf;
        for (const Shape& shape : scene.shapes) {
            const Real t = hit_sphere(std::get<Sphere>(shape.geometry), {vec3(0), d, 0, inf});
            CHECK(t < before);
            before = t;
        }
    }
}
