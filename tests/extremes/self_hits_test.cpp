/// Rays that leave a surface never meet it again where they started: extremes.md 13.

#include <algorithm>

#include "extremes/extremes.h"
#include "rt/stages/stages.h"

using namespace rt;

namespace {

/// A unit direction on the given side of n: every second one grazes, at a cosine down to 1e-16.
vec3 leaving(vec3 n, Real side, Random& random) {
    if (random.integer(0, 1)) return side * random.direction_about(n, 0);
    const Frame frame = frame_about(n);
    const vec2 around = unit_circle(random.number());
    return unit(around.x * frame.x + around.y * frame.y + side * random.scale(1e-16, 1) * n);
}

vec3 point_of(const Sphere& s, Random& random) { return s.center + s.radius * random.direction(); }
vec3 point_of(const Triangle& t, Random& random) {
    const vec2 u = random.point();
    const vec2 inside = u.x + u.y < 1 ? u : 1.0 - u;
    return t.a + inside.x * (t.b - t.a) + inside.y * (t.c - t.a);
}
vec3 point_of(const Quad& q, Random& random) {
    const vec2 u = 2.0 * random.point() - 1.0;
    return q.center + u.x * q.u + u.y * q.v;
}
vec3 point_of(const Disc& d, Random& random) {
    const Frame frame = frame_about(d.normal);
    const vec2 p = d.radius * std::sqrt(random.number()) * unit_circle(random.number());
    return d.center + p.x * frame.x + p.y * frame.y;
}

Sphere any(Sphere, Real scale, vec3 center, Random&) { return {center, scale}; }
Triangle any(Triangle, Real scale, vec3 center, Random& random) {
    // Every second one is a needle, up to 1e6 times as long as wide.
    const Real width = random.integer(0, 1) ? 1 : random.scale(1e-6, 1);
    const Frame frame = frame_about(random.direction());
    return {center, center + scale * frame.x, center + scale * (random.number() * frame.x + width * frame.y)};
}
Quad any(Quad, Real scale, vec3 center, Random& random) {
    const Frame frame = frame_about(random.direction());
    return {center, scale * frame.x, scale * random.scale(1e-6, 1) * frame.y};
}
Disc any(Disc, Real scale, vec3 center, Random& random) { return {center, random.direction(), scale}; }

struct Found {
    std::int64_t queries = 0, again = 0;
    Greatest off;  // of the points, along the normal, in units of what the ray is offset by
};

/// Rays onto one shape, and as many that leave it from where they hit. A flat shape is never met again. Nor is a sphere
/// from outside; from inside it is met on its far side, not nearer than half the chord.
template <class Shape>
void query(const Shape& shape, Real scale, Random& random, Found& found) {
    const World world = world_of({shape, 0, vec3(0)});
    Batch towards{}, away{};
    for (int i = 0; i < lanes; ++i) {
        const vec3 target = point_of(shape, random), eye = target + random.vector(1e-3 * scale, 1e3 * scale);
        towards.set_ray(i, {eye, unit(target - eye), 0, inf});
    }
    towards.count = away.count = lanes;
    nearest_stage(world, towards);
    Surfaces surfaces{};
    surface_stage(world, towards, surfaces);
    Real least[lanes];  // nearer than this the shape must not be met
    std::fill(least, least + lanes, inf);
    for (int i = 0; i < lanes; ++i) {
        away.set_ray(i, {vec3(0), vec3(0, 0, 1), 0, -inf});
        if (towards.shape[i] == nothing) continue;
        const Hit hit = surfaces.hit(i);
        const Real side = random.integer(0, 1) ? 1 : -1;
        const vec3 direction = leaving(hit.normal, side, random);
        away.set_ray(i, spawn_ray(hit, direction));
        ++found.queries;
        if constexpr (std::is_same_v<Shape, Sphere>) {
            const bool inside = exact_length(Long(away.ray(i).origin) - Long(shape.center)) < shape.radius;
            if (inside) least[i] = shape.radius * std::abs(dot(direction, unit(hit.point - shape.center)));
            found.off.see(double(std::abs(exact_length(Long(hit.point) - Long(shape.center)) - shape.radius)) /
                          hit.error);
        }
        if constexpr (std::is_same_v<Shape, Quad>) {
            const Long u(shape.u), v(shape.v), p = Long(hit.point) - Long(shape.center);
            const Long n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
            found.off.see(double(std::abs(exact_dot(p, n)) / exact_length(n)) / hit.error);
        }
    }
    nearest_stage(world, away);
    for (int i = 0; i < lanes; ++i) {
        if (away.shape[i] == nothing || away.far[i] >= least[i]) continue;
        ++found.again;
        UNSCOPED_INFO("scale " << scale << ", origin " << text(away.ray(i).origin) << ", direction "
                               << text(away.ray(i).direction) << ", met again at " << away.far[i]);
    }
}

template <class Shape>
void check_shape(const char* name, unsigned seed) {
    Random random(seed);
    Found found;
    const std::int64_t wanted = count_of(2.5e6, 5e7);
    while (found.queries < wanted) {
        const Real scale = power_of_two(random.integer(-40, 40));
        const vec3 center = random.integer(0, 3) ? random.vector(0.01 * scale, 100 * scale) : vec3(0);
        query(any(Shape{}, scale, center, random), scale, random, found);
        if (found.again > 0) break;
    }
    figure(13, std::string(name) + ": self-hits among " + std::to_string(found.queries) + " queries",
           double(found.again), 0);
    if (found.off.value > 0)
        figure(13, std::string(name) + ": points off the surface, in units of the offset", found.off.value, 0.5);
}

}  // namespace

TEST_CASE("13 a ray that leaves a sphere does not meet it where it started, at scales 2^-40 to 2^40", "[extremes]") {
    check_shape<Sphere>("sphere", 131);
}
TEST_CASE("13 a ray that leaves a triangle does not meet it again, needles included", "[extremes]") {
    check_shape<Triangle>("triangle", 132);
}
TEST_CASE("13 a ray that leaves a quad does not meet it again", "[extremes]") { check_shape<Quad>("quad", 133); }
TEST_CASE("13 a ray that leaves a disc does not meet it again", "[extremes]") { check_shape<Disc>("disc", 134); }
