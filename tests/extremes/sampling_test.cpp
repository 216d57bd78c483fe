/// Cones, lights, frames, random numbers: extremes.md 32 to 35, 37 to 39, 41 to 43.

#include <algorithm>

#include "extremes/extremes.h"
#include "rt/fragments.h"
#include "rt/sampler.h"
#include "warp.h"

using namespace rt;

namespace {

/// The irradiance of a white surface at p, from one light, by the light's own samples at u.
Real irradiance(const Emitter& light, vec3 p, vec3 n, vec2 u) {
    const LightSample sample = light_sample(light, p, u);
    Material white;
    white.albedo = Color(1);
    return pi * direct_light(white, light.radiance, sample, n, n).x;
}

Emitter sphere_light(vec3 center, Real radius, Real radiance) {
    return {Emitter::Kind::sphere, {}, {}, {center, radius}, Color(radiance)};
}

/// Nodes and weights of Gauss and Legendre on [0, 1], eight points.
const Real nodes[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
const Real weights[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

/// The integral of f over [0, 1] where f may change within a tiny part of it next to 0: cut at powers of two.
template <class F>
Real integral_towards_0(F f) {
    Sum sum;
    for (int k = 0; k < 240; ++k) {
        const Real high = power_of_two(-k), low = high / 2, half = (high - low) / 2, middle = (high + low) / 2;
        for (int i = 0; i < 4; ++i)
            for (const int side : {-1, 1}) sum.add(half * weights[i] * f(middle + side * half * nodes[i]));
    }
    return sum.value();
}

}  // namespace

TEST_CASE("32 the cone towards a sphere at d/r = 1 to 1e8 and beyond: relative 8u", "[extremes]") {
    Random random(32);
    Greatest density, cosine, sine;
    for (int k = 0; k < 200000; ++k) {
        const Real s = k % 2 ? 1 / random.scale(1e4, 1e8) : 1 / random.scale(1.01, 1e30);
        const vec2 u = random.point();
        const DirectionSample cone = sphere_cone(s, u);
        const long double m = (long double)(s)*s / (1 + std::sqrt(1 - (long double)(s)*s)), c = (long double)(u.x) * m;
        density.see(double(std::abs(cone.density * 2 * 3.14159265358979323846264L * m - 1)) / roundoff);
        cosine.see(double(std::abs(cone.direction.z - (1 - c))) / roundoff);
        const long double across = std::sqrt((long double)(cone.direction.x) * cone.direction.x +
                                             (long double)(cone.direction.y) * cone.direction.y);
        if (u.x > 0) sine.see(double(std::abs(across / std::sqrt(c * (2 - c)) - 1)) / roundoff);
    }
    figure(32, "density of the cone, relative, in u", density.value, 8);
    figure(32, "cosine, in u", cosine.value, 8);
    figure(32, "sine, relative, in u", sine.value, 8);
}

TEST_CASE("33 a sphere light of radiance I/(pi r^2), r/d = 1e-8 to 0.999: lights as the point light", "[extremes]") {
    Random random(33);
    Greatest worst;
    for (int k = 0; k < 300; ++k) {
        const Real distance = random.scale(1e-3, 1e3),
                   share = k % 3 ? random.scale(1e-8, 0.999) : random.between(0.5, 0.999);
        const vec3 p = 10.0 * random.in_cube(), n = random.direction();
        const Real radius = share * distance;
        const Emitter light = sphere_light(p + distance * n, radius, 1 / (pi * radius * radius));
        // Over the cone the cosine is linear in u.x, so that few midpoints are the whole integral.
        const Real e = square_mean(16, [&](vec2 u) { return irradiance(light, p, n, u); });
        const Real point = point_irradiance({p + distance * n, Color(1), false}, p, n).x;
        // p is rounded to 10u: as a share of the distance.
        worst.see(std::abs(e / point - 1) / (1 + 100 * roundoff / distance / 1e-12));
    }
    figure(33, "sphere light against point light, relative", worst.value, 1e-12);
}

TEST_CASE("34 a sphere light that touches the floor: E = pi L r^3/(rho^2 + r^2)^1.5, from the contact outwards",
          "[extremes]") {
    Greatest worst, highest;
    for (const Real scale : {1e-6, 1.0, 1e6})
        for (const Real rho : {1e-6, 1e-3, 0.1, 0.5, 1.0, 3.0, 100.0, 1e4}) {
            const Real r = 2 * scale, offset = rho * r;
            const Emitter light = sphere_light({0, 0, r}, r, 3);
            const vec3 p{offset, 0, 0}, n{0, 0, 1};
            Real most = 0;
            const Real e = square_mean(500, [&](vec2 u) {
                const Real one = irradiance(light, p, n, u);
                most = std::max(most, one);
                return one;
            });
            const Real due = pi * 3 * r * r * r / std::pow(offset * offset + r * r, 1.5);
            INFO("rho / r " << rho << ": " << e << " for " << due);
            worst.see(std::abs(e / due - 1));
            highest.see(most / (2 * pi * 3));
        }
    figure(34, "sphere on the floor, 250000 samples of the square, relative", worst.value, 1e-3);
    figure(34, "largest sample, in 2 pi L: no weight grows without bound", highest.value, 1 + 1e-12);
}

TEST_CASE("35 a coaxial disc light at h = 1e-9 R to 1e9 R: E = pi L R^2/(R^2 + h^2)", "[extremes]") {
    Greatest worst;
    for (int k = -9; k <= 9; ++k)
        for (const Real radius : {1e-6, 1.0, 1e6}) {
            const Real h = radius * std::pow(10.0, k);
            Emitter light;
            light.kind = Emitter::Kind::disc;
            light.disc = {{0, 0, h}, {0, 0, -1}, radius};
            light.radiance = Color(5);
            const Real e = integral_towards_0([&](Real u) { return irradiance(light, vec3(0), {0, 0, 1}, {u, 0.3}); });
            worst.see(std::abs(e / (pi * 5 * radius * radius / (radius * radius + h * h)) - 1));
        }
    figure(35, "disc light on the axis, relative", worst.value, 1e-9);
}

TEST_CASE("37 a shading point on the light: finite", "[extremes]") {
    Random random(37);
    const auto finite = [](const Emitter& light, vec3 p, vec3 n, vec2 u) {
        return std::isfinite(irradiance(light, p, n, u));
    };
    int infinite = 0;
    for (int k = 0; k < 100000; ++k) {
        const vec2 u = k % 3 ? random.point() : vec2(0.5);
        const vec3 n = random.direction();
        Emitter light;
        light.quad = {random.in_cube(), {1, 0, 0}, {0, 1, 0}};
        light.disc = {random.in_cube(), n, 1};
        const vec3 on_quad = light.quad.center + (2 * u.x - 1) * light.quad.u + (2 * u.y - 1) * light.quad.v;
        infinite += !finite(light, on_quad, {0, 0, -1}, u) + !finite(light, light.quad.center, n, u);
        light.kind = Emitter::Kind::disc;
        infinite += !finite(light, light.disc.center, n, u) + !finite(light, light.disc.center + 1e-300 * n, -n, u);
        light = sphere_light(random.in_cube(), random.scale(1e-9, 1), 1);
        infinite += !finite(light, light.sphere.center + light.sphere.radius * n, n, u) +
                    !finite(light, light.sphere.center, n, u);
    }
    figure(37, "samples from points on the light that are not finite, of 600000", infinite, 0);
}

TEST_CASE("38 orthonormal frames: axes, poles, 1e7 random normals within 4u", "[extremes]") {
    Random random(38);
    Greatest worst, worst_of_unit;
    const auto look = [](vec3 n, Greatest& greatest) {
        const Frame f = frame_about(n);
        const Long x(f.x), y(f.y), z(n);
        for (const long double off :
             {exact_dot(x, y), exact_dot(x, z), exact_dot(y, z), exact_length(x) - 1, exact_length(y) - 1})
            greatest.see(double(std::abs(off)) / roundoff);
        return f;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const Real sign : {-1.0, 1.0})
            for (const Real zero : {0.0, -0.0}) {
                vec3 n(zero);
                n[axis] = sign;
                const Frame f = look(n, worst);
                CHECK(cross(f.x, f.y) == n);
            }
    for (int k = 0; k < 100000; ++k) {
        const vec2 near = random.scale(1e-20, 1e-3) * unit_circle(random.number());
        look({near.x, near.y, k % 2 ? -std::sqrt(1 - dot(near, near)) : std::sqrt(1 - dot(near, near))}, worst);
    }
    const std::int64_t n = count_of(1e7, 1e8);
    for (std::int64_t k = 0; k < n; ++k) {
        const vec3 v = random.in_cube();
        if (v == vec3(0)) continue;
        look(vec3(Long(v) / exact_length(Long(v))), worst);
        look(unit(v), worst_of_unit);
    }
    figure(38, "frames about normals that unit() made, whose length is off by up to 3u", worst_of_unit.value, 8);
    figure(38, "frames: dot products and lengths off by, in u", worst.value, 4);
}

TEST_CASE("39 random numbers and strata are always below 1", "[extremes]") {
    CHECK(to_unit(~Bits(0)) < 1);
    CHECK(to_unit(0) == 0);
    CHECK(to_unit(~Bits(0)) == 1 - 0x1p-52);
    CHECK(std::uint32_t(-1) * 0x1p-32 < 1);
    int outside = 0;
    for (const int n : {1, 2, 3, 7, 64, 1000, 65521, 1 << 20, (1 << 24) + 1, (1 << 30) - 1, 1 << 30})
        for (const int i : {0, n / 2, n - 1})
            for (const Real u : {0.0, 0.5, 1 - 0x1p-32, 1 - 0x1p-52, below_one}) {
                const vec2 p = stratified_2d(i, n, {u, u});
                outside += !(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
            }
    Random random(39);
    for (int k = 0; k < 1000000; ++k) {
        const int n = random.integer(1, 1 << 30), i = random.integer(0, n - 1);
        const Bits key = random.engine();
        for (const Real u : {pattern_1d<Sampler::stratified>(key, i, n, 3), pattern_1d<Sampler::uniform>(key, i, n, 3),
                             pattern_1d<Sampler::random>(key, i, n, 3), pattern_1d<Sampler::sobol>(key, i, n, 3)})
            outside += !(u >= 0 && u < 1);
    }
    figure(39, "numbers of samplers and strata outside 0 <= u < 1", outside, 0);
}

TEST_CASE("42 densities up to 1e300 and down to 1e-300: finite", "[extremes]") {
    Material m;
    m.albedo = m.specular = Color(0.5);
    m.shininess = 1e9;
    for (const Real density : {1e-300, 1e-30, 1.0, 1e30, 1e300, inf})
        for (const Real radiance : {0.0, 1e-30, 1e30}) {
            const Color c = direct_light(m, Color(radiance), {{0, 0, 1}, 1, density}, {0, 0, 1}, {0, 0, 1});
            INFO("density " << density << ", radiance " << radiance);
            if (density > 1e-270) CHECK(std::isfinite(c.x));
            CHECK(c.x >= 0);
        }
}

TEST_CASE("43 the middle of the disc, the rim of the hemisphere, the tail of the lobe: finite", "[extremes]") {
    for (const Real x : {0.0, 4.9e-324, 1e-300, 0x1p-52, 0.5, below_one})
        for (const Real y : {0.0, 0.25, 0.5, below_one}) {
            const auto good = [](const DirectionSample& s) {
                return std::abs(dot(s.direction, s.direction) - 1) < 1e-15 * 8 && s.density >= 0 &&
                       std::isfinite(s.density);
            };
            CHECK(good(cosine_hemisphere({x, y})));
            for (const Real exponent : {0.0, 1e-300, 1.0, 1e9, 1e300}) {
                INFO("u " << x << ", " << y << ", exponent " << exponent);
                CHECK(good(phong_lobe(exponent, {x, y})));
            }
            for (const Real sine : {1e-150, 1e-8, 0.5, below_one, 1.0}) CHECK(good(sphere_cone(sine, {x, y})));
            for (const Real g : {-below_one, -0.5, 0.0, 0.5, below_one}) {
                INFO("u " << x << ", " << y << ", g " << g);
                CHECK(good(scatter_direction({0, 0, 1}, g, {x, y})));
            }
            CHECK(std::isfinite(uniform_disk({x, y}).point.x));
        }
}
