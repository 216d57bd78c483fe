/// Which rays, of a beam or alone, a triangle need not be asked about: what is left out is never a hit, however close,
/// and nearly all that pass by at some distance are left out.

#include <bit>
#include <optional>

#include "extremes/extremes.h"
#include "rt/fragments.h"
#include "rt/tree/shears.h"

using namespace rt;

namespace {

struct Counts {
    std::int64_t left_out = 0, hit_though_left_out = 0, beside = 0, beside_left_out = 0, hits = 0;
};

/// A triangle, not larger than size, within 2.5 of `middle`, which the tree is about.
Triangle triangle_in(Random& random, vec3 middle, Real size) {
    const vec3 a = middle + 0.5 * random.in_cube(), along = size * random.in_cube();
    const Real thin = random.integer(0, 3) ? 1 : random.scale(1e-9, 1);
    return {a, a + along, a + (random.integer(0, 1) ? along : vec3(0)) + thin * size * random.in_cube()};
}

/// A point on a corner or an edge, within the triangle, or beside it by up to its size.
vec3 target_at(Random& random, const Triangle& t, int kind) {
    const Real s = random.number(), r = random.number();
    if (kind == 0) return random.integer(0, 1) ? t.a : t.c;
    if (kind == 1) return t.a + s * (t.b - t.a);
    if (kind == 2) return t.b + s * (t.c - t.b);
    const vec3 inside = t.a + s * ((t.b + r * (t.c - t.b)) - t.a);
    if (kind == 3) return inside;
    return inside + (random.integer(0, 1) ? 1 : 1e-9) * length(t.c - t.a) * random.in_cube();
}

/// Rays from about one point.
Batch beam_at(Random& random, const Triangle& t, Real distance) {
    const vec3 eye = t.a + distance * random.direction();
    Batch b{};
    b.count = lanes;
    for (int i = 0; i < lanes; ++i) {
        const vec3 from = eye + 0.01 * random.in_cube();
        b.set_ray(i, {from, random.scale(0.1, 10) * unit(target_at(random, t, i % 5) - from), 0, inf});
    }
    return b;
}

/// By how much of its size the ray passes the triangle, at least, measured in the plane of its corners.
Real beside(const Triangle& t, const Ray& ray) {
    const vec3 n = cross(t.b - t.a, t.c - t.a);
    const vec3 p = ray.origin + dot(t.a - ray.origin, n) / dot(ray.direction, n) * ray.direction;
    const Real area = dot(n, n);
    const Real u = dot(cross(t.c - t.b, p - t.b), n) / area, v = dot(cross(t.a - t.c, p - t.c), n) / area,
               w = 1 - u - v;
    return -std::min(u, std::min(v, w));
}

enum class Together { yes, no };

/// Those of the rays that the triangle is asked about; none: they have no axis in common.
std::optional<std::uint64_t> left_of(const Bvh& bvh, const Journeys& journeys, Together together, std::uint64_t rays) {
    static Beam beam;
    static Shears shears;
    if (together == Together::yes) {
        start(journeys, beam);
        if (!start(journeys, beam, shears)) return std::nullopt;
        return may_hit(bvh.corners[0], 0, shears, rays);
    }
    start(journeys, shears);
    std::uint64_t left = 0;
    for (int i = 0; i < lanes; ++i) left |= std::uint64_t(may_hit(bvh.corners[0], shears, i) & 1) << i;
    return left & rays;
}

void count(Random& random, vec3 middle, Real size, Real distance, Together together, Counts& counts) {
    static Journeys journeys;
    const Triangle t = triangle_in(random, middle, size);
    Bvh bvh = build_bvh(1, [&](std::size_t) { return Box{middle - 2.5, middle + 2.5}; });
    add_corners(bvh, [&](std::size_t) { return &t; });
    const Batch b = beam_at(random, t, distance);
    start(bvh, b, journeys);
    std::uint64_t alive = 0;
    for (int i = 0; i < lanes; ++i) alive |= std::uint64_t(journeys.far[i] >= 0) << i;
    const std::optional<std::uint64_t> left = left_of(bvh, journeys, together, alive);
    if (!left) return;
    const bool plump =
        length(cross(t.b - t.a, t.c - t.a)) > 0.1 * sqr(length(t.c - t.a)) && length(t.c - t.a) > 0.3 * size;
    for (int i = 0; i < lanes; ++i) {
        const bool out = !(*left >> i & 1), hit = hit_triangle(t, b.ray(i)) < inf;
        const bool far_beside = plump && (alive >> i & 1) && beside(t, b.ray(i)) > 0.05;
        counts.left_out += out, counts.hits += hit, counts.hit_though_left_out += out && hit;
        counts.beside += far_beside, counts.beside_left_out += far_beside && out;
    }
}

}  // namespace

TEST_CASE("a ray that is left out of a triangle's never hits it", "[hit_triangle]") {
    const Together together = GENERATE(Together::yes, Together::no);
    Random random(11);
    Counts counts;
    for (int round = 0; round < 20000; ++round)
        count(random, round % 4 ? vec3(0) : random.scale(1, 1e9) * random.direction(), random.scale(1e-7, 1),
              random.scale(0.05, 1e5), together, counts);
    INFO(counts.hits << " hits, " << counts.left_out << " left out");
    CHECK(counts.hits > 100000);
    CHECK(counts.left_out > 40000);
    CHECK(counts.hit_though_left_out == 0);
}

TEST_CASE("and what passes a triangle of ordinary size by is left out", "[hit_triangle]") {
    const Together together = GENERATE(Together::yes, Together::no);
    Random random(12);
    Counts counts;
    for (int round = 0; round < 5000; ++round)
        count(random, vec3(0), random.scale(0.003, 1), random.scale(0.5, 100), together, counts);
    INFO(counts.beside << " rays pass by");
    CHECK(counts.beside > 10000);
    CHECK(double(counts.beside_left_out) > 0.98 * double(counts.beside));
}
