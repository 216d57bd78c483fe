#include "catch.h"
#include "random.h"
#include "rt/fragments.h"
#include "warp.h"

using namespace rt;

namespace {

/// A direction of travel that meets the normal z at an angle.
vec3 at_angle(Real degrees) { return {std::sin(degrees * pi / 180), 0, -std::cos(degrees * pi / 180)}; }

Real glossy_albedo(Real degrees, Real exponent) {
    return square_mean(600, [=](vec2 u) {
        return glossy_reflection(at_angle(degrees), {0, 0, 1}, exponent, u).weight.x;
    });
}

}  // namespace

TEST_CASE(
    "glossy_reflection: at normal incidence no light is lost; at 60 and 80 degrees what goes below the surface is") {
    CHECK(glossy_albedo(0, 10) == Approx(1).epsilon(1e-4));
    CHECK(glossy_albedo(0, 50) == Approx(1).epsilon(1e-4));
    CHECK(glossy_albedo(60, 10) == Approx(0.505).margin(1e-3));
    CHECK(glossy_albedo(80, 10) == Approx(0.228).margin(1e-3));
    CHECK(glossy_albedo(60, 50) == Approx(0.500).margin(1e-3));
    CHECK(glossy_albedo(80, 50) == Approx(0.181).margin(1e-3));
}

TEST_CASE("glossy_reflection: the lobe is about the mirror direction, E cos = (n+1)/(n+2), E sin^2 = 2/(n+3)") {
    Random random(1);
    for (const Real exponent : {1.0, 10.0, 200.0}) {
        const vec3 n = random.direction(), d = -random.direction_about(n), axis = d - 2 * dot(d, n) * n;
        INFO("exponent " << exponent << ", d " << text(d) << ", n " << text(n));
        const Real cosine =
            square_mean(300, [=](vec2 u) { return dot(glossy_reflection(d, n, exponent, u).direction, axis); });
        CHECK(cosine == Approx((exponent + 1) / (exponent + 2)).epsilon(1e-3));
        const Real sine2 = square_mean(
            300, [=](vec2 u) { return 1 - sqr(dot(glossy_reflection(d, n, exponent, u).direction, axis)); });
        CHECK(sine2 == Approx(2 / (exponent + 3)).epsilon(5e-3));
    }
}

TEST_CASE("glossy_reflection, translucency: the weight is BRDF x cosine / density; nothing on the wrong side") {
    Random random(2);
    int lost = 0;
    for (int i = 0; i < 2000; ++i) {
        const bool through = i % 2;
        const vec3 n = random.direction(), d = -random.direction_about(n);
        const Real exponent = random.scale(1, 100), from = random.between(1, 2), to = random.between(1, 2);
        const vec2 u = 0.01 + 0.98 * random.point();
        const vec3 axis = through ? refracted_direction(d, n, from, to) : mirror_direction(d, n);
        const auto scattered = [&](vec2 v) {
            return through ? translucency(d, n, from, to, exponent, v) : glossy_reflection(d, n, exponent, v);
        };
        const Scattered sample = scattered(u);
        INFO((through ? "translucency" : "glossy_reflection")
             << ", d " << text(d) << ", n " << text(n) << ", exponent " << exponent << ", from " << from << " to " << to
             << ", u " << text(u));
        const Real cosine = (through ? -1 : 1) * dot(sample.direction, n);
        if (axis == vec3(0) || cosine <= 0) {
            CHECK(sample.weight == Color(0));
            ++lost;
            continue;
        }
        const Real brdf = (exponent + 2) / (2 * pi) * std::pow(dot(sample.direction, axis), exponent);
        const Real stretch = area_stretch([&](vec2 v) { return scattered(v).direction; }, u);
        CHECK(sample.weight.x == Approx(brdf * cosine * stretch).epsilon(1e-3));
        CHECK(sample.weight == Color(sample.weight.x));
    }
    CHECK(lost > 50);
}

TEST_CASE("translucency: E cos = (n+1)/(n+2) about the refracted direction; no light lost straight through") {
    const Real exponent = 20;
    const vec3 n(0, 0, 1), d = at_angle(40), axis = refracted_direction(d, n, 1, 1.5);
    const Real cosine =
        square_mean(300, [=](vec2 u) { return dot(translucency(d, n, 1, 1.5, exponent, u).direction, axis); });
    CHECK(cosine == Approx((exponent + 1) / (exponent + 2)).epsilon(1e-3));
    CHECK(square_mean(300, [=](vec2 u) { return translucency(-n, n, 1, 1.5, exponent, u).weight.x; }) ==
          Approx(1).epsilon(1e-4));
}

TEST_CASE("glossy_reflection, translucency: finite at the corners of the square") {
    const vec3 n(0, 0, 1), d = at_angle(30);
    for (const Real exponent : {0.0, 1.0, 1e6})
        for (const Real x : {0.0, 1 - 0x1p-32})
            for (const Real y : {0.0, 1 - 0x1p-32})
                for (const Scattered& sample :
                     {glossy_reflection(d, n, exponent, {x, y}), translucency(d, n, 1, 1.5, exponent, {x, y})}) {
                    INFO("exponent " << exponent << ", u " << x << " " << y << ", weight " << text(sample.weight));
                    CHECK((sample.weight.x >= 0 && sample.weight.x < 3));
                    CHECK(dot(sample.direction, sample.direction) == Approx(1).epsilon(1e-12));
                }
}

TEST_CASE(
    "color_bleeding: a diffuse surface keeps its albedo's share of the light, and the weight is BRDF x cosine / "
    "density") {
    Random random(3);
    const Color albedo(0.2, 0.5, 0.9);
    for (int i = 0; i < 300; ++i) {
        const vec3 n = random.direction();
        const vec2 u = 0.01 + 0.98 * random.point();
        const Scattered sample = color_bleeding(n, albedo, u);
        const Real cosine = dot(sample.direction, n);
        INFO("n " << text(n) << ", u " << text(u) << ", direction " << text(sample.direction));
        CHECK(cosine > 0);
        CHECK(dot(sample.direction, sample.direction) == Approx(1).epsilon(1e-12));
        const Real stretch = area_stretch([&](vec2 v) { return color_bleeding(n, albedo, v).direction; }, u);
        CHECK(sample.weight.x == Approx(albedo.x / pi * cosine * stretch).epsilon(1e-3));
        CHECK(sample.weight.y / sample.weight.x == Approx(albedo.y / albedo.x).epsilon(1e-12));
    }
    const Color mean = square_mean(200, [=](vec2 u) { return color_bleeding({0, 0, 1}, albedo, u).weight; });
    CHECK(mean.x == Approx(albedo.x).epsilon(1e-4));
    CHECK(mean.z == Approx(albedo.z).epsilon(1e-4));
}

TEST_CASE("color_bleeding: goes everywhere over the hemisphere, evenly around the normal") {
    Random random(4);
    const vec3 n = unit({1, -2, -3});
    const Frame frame = frame_about(n);
    Real weight = 0;
    const Real p = uniform_probability([&] {
        const Scattered sample = color_bleeding(n, Color(1), random.point());
        weight += sample.weight.x;
        return vec2(sqr(dot(sample.direction, n)),
                    turn(dot(sample.direction, frame.x), dot(sample.direction, frame.y)));
    });
    CHECK(p > 1e-4);
    CHECK(weight / 100000 == Approx(1).epsilon(1e-12));
}
