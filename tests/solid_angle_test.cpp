#include "rt/lamps/solid_angle.h"

#include <cmath>
#include <random>

#include "catch.h"
#include "estimate.h"
#include "rt/files/scene_reader.h"
#include "rt/fragments.h"
#include "rt/lamps/importance.h"
#include "rt/sampler.h"
#include "scenes.h"

using namespace rt;

namespace {

/// Lamps of each kind near a floor and a glossy ball, one of them a quad at an angle.
const std::string lamps =
    scene_table("[render]", {{"samples", 64}}) + camera({0, 2, 5}, {0, 0.5, 0}, {{"size", "[32, 20]"}}) +
    material("grey", {{"albedo", 0.6}}) + material("lamp", {{"emission", 1}}) +
    material("glossy", {{"reflectance", 0.9}, {"exponent", 30}, {"albedo", 0.05}}) +
    quad("grey", {0, 0, 0}, {3, 0, 0}, {0, 0, -3}) + quad("lamp", {0, 0.5, 0}, {1, 0, 0}, {0, 0, 1}) +
    quad("lamp", {-1.5, 1, 0}, {0.3, 0.4, 0}, {0, 0, -0.7}) + sphere("glossy", {1.5, 0.5, 0.5}, 0.5) +
    disc("lamp", {1, 1.5, 1}, {0, -1, 0}, 0.2);

/// Of the part of a quad from x0 to x, in more digits.
long double solid_angle(const SeenQuad& q, Real x) {
    const auto corner = [&](long double cx, long double cy) {
        const long double z = q.height;
        return std::atan(cx * cy / (z * std::sqrt(cx * cx + cy * cy + z * z)));
    };
    return corner(q.x0, q.y0) - corner(q.x0, q.y1) - corner(x, q.y0) + corner(x, q.y1);
}

struct Place {
    Quad quad;
    vec3 p;
};

/// A point before, beside or behind a quad, from far away to close by.
Place any_place(std::mt19937_64& engine) {
    std::uniform_real_distribution<Real> share(0, 1);
    const auto number = [&](Real low, Real high) { return low + share(engine) * (high - low); };
    const Frame frame = frame_about(unit(vec3(number(-1, 1), number(-1, 1), number(-1, 1))));
    const Real size = std::exp(number(-7, 7));
    const vec3 center{number(-1, 1), number(-1, 1), number(-1, 1)};
    const Quad quad{size * center, size * frame.x, size * std::exp(number(-4, 0)) * frame.y};
    const vec3 off{number(-3, 3), number(-3, 3), std::exp(number(-9, 3)) * (share(engine) < 0.1 ? -1 : 1)};
    return {quad, quad.center + size * frame.to_world(off)};
}

}  // namespace

TEST_CASE("solid angle: that of a quad, and points that share it evenly") {
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<Real> share(0, 1);
    int wide = 0, narrow = 0, behind = 0;
    for (int k = 0; k < 100'000; ++k) {
        const auto [quad, p] = any_place(engine);
        const SeenQuad seen = seen_from(quad, p);
        behind += seen.height<0, narrow += seen.height> 0 && !seen.is_wide(), wide += seen.is_wide();
        if (!seen.is_wide()) continue;
        const vec2 u(share(engine), share(engine));
        const long double whole = solid_angle(seen, seen.x1);
        CAPTURE(k, seen.height, seen.solid_angle, u.x, u.y);
        REQUIRE(std::abs(seen.solid_angle / whole - 1) < 1e-11);

        const LightSample sample = sample_by_angle(seen, u);
        REQUIRE(sample.density == 1 / seen.solid_angle);
        const vec3 to = sample.distance * sample.direction;
        const Real size = std::sqrt(dot(quad.u, quad.u)), x = dot(to, seen.x), y = dot(to, seen.y);
        REQUIRE(std::abs(dot(sample.direction, sample.direction) - 1) < 1e-14);
        REQUIRE(std::abs(dot(p + to - quad.center, seen.normal)) < 1e-14 * (size + largest(p)));
        REQUIRE((x >= seen.x0 - 1e-14 * size && x <= seen.x1 + 1e-14 * size));
        // the part to its left, and on the way up through it
        REQUIRE(std::abs(Real(solid_angle(seen, x) / whole) - u.x) < 1e-8);
        const auto sine = [&](Real at) { return at / std::hypot(x, at, seen.height); };
        REQUIRE(std::abs((sine(y) - sine(seen.y0)) / (sine(seen.y1) - sine(seen.y0)) - u.y) < 1e-7);
    }
    CHECK(wide > 20'000);
    CHECK(narrow > 1'000);
    CHECK(behind > 1'000);
}

TEST_CASE(
    "solid angle: on the plane, at edges and corners, and where numbers end, a point of the area is asked for or all "
    "is finite") {
    for (const Real size : {1e-200, 1e-100, 1e-6, 1., 1e6, 1e100, 1e200}) {
        const Quad quad{{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
        for (const Real x : {-2., -1., 0., 1., 3.})
            for (const Real y : {-1., 0., 1., 5.})
                for (const Real z : {0., 1e-300, 1e-15, 1e-3, 1., -1.}) {
                    const SeenQuad seen = seen_from(quad, {size * x, size * y, size * z});
                    CAPTURE(size, x, y, z, seen.solid_angle);
                    if (z < 1e-12) CHECK(!seen.is_wide());
                    if (!seen.is_wide()) continue;
                    for (const Real u : {0., 0.3, below_one}) {
                        const LightSample s = sample_by_angle(seen, {u, 1 - u});
                        CHECK((std::isfinite(s.distance) && s.distance >= 0));
                        CHECK(dot(s.direction, s.direction) == Approx(1));
                        CHECK((s.density > 0.1 && s.density <= 1 / SeenQuad::least));
                    }
                }
    }
}

TEST_CASE("solid angle: the same picture, alone and with multiple importance sampling") {
    Scene scene = parse_scene(lamps, "lamps.toml");
    for (const bool both : {false, true})
        for (const Sampler sampler : {Sampler::random, Sampler::sobol}) {
            scene.multiple_importance = both;
            scene.solid_angle = false;
            const Estimate by_area = estimate(scene, sampler, 40);
            scene.solid_angle = true;
            const Estimate by_angle = estimate(scene, sampler, 40);
            CAPTURE(both, int(sampler), by_area.mean.x, by_angle.mean.x);
            CHECK(std::abs(by_area.mean.x - by_angle.mean.x) <
                  4.5 * std::sqrt(by_area.variance.x + by_angle.variance.x));
        }
}

TEST_CASE("solid angle: less noise near a large lamp") {
    Scene scene = parse_scene(lamps, "lamps.toml");
    scene.shapes.resize(2);
    scene.solid_angle = false;
    const Real by_area = estimate(scene, Sampler::orthogonal, 10).noise;
    scene.solid_angle = true;
    const Real ratio = by_area / estimate(scene, Sampler::orthogonal, 10).noise;
    CAPTURE(ratio);
    CHECK(ratio > 10);
}

TEST_CASE("solid angle: the density with which multiple importance sampling weighs is the same") {
    Scene scene = parse_scene(lamps, "lamps.toml");
    scene.solid_angle = scene.multiple_importance = true;
    const World world = make_world(scene);
    const Index lamp = world.first_quad + 1;
    for (const vec3 p : {vec3(0.3, 0.1, -0.2), vec3(3, 0, 2), vec3(0, -40, 0)}) {
        const SeenQuad seen = seen_from(world.quads[1], p);
        for (int i = 0; i < 20; ++i) {
            const vec2 u = sobol_2d(5, std::uint32_t(i), 2);
            const LightSample s = seen.is_wide() ? sample_by_angle(seen, u) : light_sample(world.emitters[0], p, u);
            CAPTURE(p.y, i);
            CHECK(light_density(world, world.surfaces[std::size_t(lamp)], {p, s.direction, 0, inf}, s.distance) ==
                  Approx(s.density));
        }
    }
}

TEST_CASE("solid angle: without quads that shine everything stays as it is") {
    Scene scene = parse_scene(lamps, "lamps.toml");
    std::erase_if(scene.shapes, [&](const Shape& s) {
        return std::holds_alternative<Quad>(s.geometry) &&
               scene.materials[std::size_t(s.material)].emission != Color(0);
    });
    scene.solid_angle = false;
    const Image without = render(scene, {.samples = 4, .estimate_error = false}).image;
    scene.solid_angle = true;
    CHECK(!make_plan(scene).solid_angle);
    CHECK(render(scene, {.samples = 4, .estimate_error = false}).image.pixels == without.pixels);
}
