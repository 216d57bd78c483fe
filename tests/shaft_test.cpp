#include "rt/tree/shaft.h"

#include <random>

#include "catch.h"
#include "rt/fragments.h"

using namespace rt;

namespace {

struct Drawn {
    std::mt19937_64 engine{11};
    Real operator()(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(engine); }
    vec3 point(Real size) {
        const Real x = (*this)(-size, size), y = (*this)(-size, size), z = (*this)(-size, size);
        return {x, y, z};
    }
};

/// Rays from about one point into about one direction.
Batch beam(Drawn& random, vec3 from, vec3 towards, Real width, Real spread) {
    Batch b;
    b.count = lanes;
    for (int i = 0; i < lanes; ++i) {
        const vec3 origin = from + random.point(width), direction = towards + random.point(spread);
        b.set_ray(i, {origin, direction, 0, inf});
    }
    return b;
}

}  // namespace

TEST_CASE("a shape that a ray of the batch meets is never left out") {
    Drawn random;
    int met = 0, left_out = 0;
    for (int k = 0; k < 20'000; ++k) {
        const Real scale = std::ldexp(1.0, int(random(-40, 40)));
        const vec3 axis = k % 4 == 0 ? vec3(0, 0, 1) : random.point(1);
        const Real width = k % 3 == 0 ? 0 : random(0, 0.5) * scale, spread = k % 5 == 0 ? 0 : random(0, 0.5);
        const Batch b = beam(random, scale * random.point(2), axis, width, spread);
        const Shaft shaft = shaft_of(b);
        const Sphere sphere{scale * random.point(3), scale * random(0.01, 1)};
        const Box box{sphere.center - sphere.radius, sphere.center + sphere.radius};
        bool hit = false;
        for (int i = 0; i < lanes; ++i) hit |= hit_sphere(sphere, b.ray(i)) < inf;
        const bool tried = may_meet(shaft, box);
        met += hit, left_out += !tried;
        INFO("beam " << k);
        CHECK((!hit || tried));
    }
    // it would be of no use if it never left anything out
    CHECK(met > 1000);
    CHECK(left_out > 10'000);
}

TEST_CASE("grazing rays keep their shape") {
    Drawn random;
    for (int k = 0; k < 20'000; ++k) {
        // from far away past the rim, as near as numbers allow
        const Sphere sphere{random.point(1), random(0.1, 1)};
        const vec3 far = sphere.center + vec3(0, 0, random(1, 1e6));
        const Real angle = random(0, 2 * pi), off = sphere.radius * (1 + random(-4, 4) * roundoff);
        const vec3 rim = sphere.center + off * vec3(std::cos(angle), std::sin(angle), 0);
        const vec3 origin = rim + vec3(0, 0, far.z - sphere.center.z);
        Batch b;
        b.count = lanes;
        for (int i = 0; i < lanes; ++i) b.set_ray(i, {origin, vec3(0, 0, -1), 0, inf});
        const Box box{sphere.center - sphere.radius, sphere.center + sphere.radius};
        const bool hit = hit_sphere(sphere, b.ray(0)) < inf;
        INFO("ray " << k);
        CHECK((!hit || may_meet(shaft_of(b), box)));
    }
}

TEST_CASE("rays that are not in use do not count") {
    Batch b;
    b.count = lanes;
    for (int i = 0; i < lanes; ++i) b.set_ray(i, {vec3(0), vec3(0, 0, 1), 0, -inf});
    CHECK(shaft_of(b).empty());
    b.set_ray(5, {vec3(1, 2, 3), vec3(0, 0, 1), 0, inf});
    const Shaft shaft = shaft_of(b);
    CHECK_FALSE(shaft.empty());
    CHECK(shaft.origins.low == vec3(1, 2, 3));
    CHECK(shaft.origins.high == vec3(1, 2, 3));
    CHECK(may_meet(shaft, {vec3(0, 1, 9), vec3(2, 3, 10)}));
    CHECK_FALSE(may_meet(shaft, {vec3(0, 1, 1), vec3(2, 3, 2)}));   // behind
    CHECK_FALSE(may_meet(shaft, {vec3(2, 1, 9), vec3(3, 3, 10)}));  // beside
}
