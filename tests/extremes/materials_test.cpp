/// Highlights, lobes, glass: extremes.md 46 to 51, 56, 67.

#include "extremes/extremes.h"
#include "rt/fragments.h"

using namespace rt;

namespace {

constexpr long double exact_pi = 3.14159265358979323846264338327950288L;

/// |a - b|^2/2 = 1 - cosine, of unit vectors.
long double one_minus_cosine(vec3 a, vec3 b) {
    const Long off = Long(a) / exact_length(Long(a)) - Long(b) / exact_length(Long(b));
    return exact_dot(off, off) / 2;
}

}  // namespace

TEST_CASE("46 highlights of exponent 1e2 to 1e9 near their axis: relative 1e-10", "[extremes]") {
    Random random(46);
    Greatest of_phong, of_area;
    for (int k = 0; k < 200000; ++k) {
        const vec3 n = random.direction(), to_light = random.direction_about(n, 0.05);
        const vec3 mirrored = unit(2 * dot(n, to_light) * n - to_light);
        Material m;
        m.specular = Color(1);
        m.shininess = random.scale(1e2, 1e9);
        // Within the lobe: at angles of its width.
        const Frame frame = frame_about(mirrored);
        const vec2 off = std::sqrt(2 / m.shininess) * random.scale(1e-2, 2) * unit_circle(random.number());
        const vec3 to_viewer = unit(mirrored + off.x * frame.x + off.y * frame.y);
        if (dot(n, to_viewer) <= 0) continue;
        // r as the vectors have it, without its rounding, and the lobe by its definition.
        const Long l(to_light), h(n);
        const long double along = exact_dot(l, h) / exact_dot(h, h);
        const Long r = 2 * along * h - l;
        const Long apart = r / exact_length(r) - Long(to_viewer) / exact_length(Long(to_viewer));
        const long double due = std::exp(m.shininess * std::log1p(-exact_dot(apart, apart) / 2));
        of_phong.see(double(std::abs(phong(m, Color(0), Color(1), n, to_light, to_viewer).x / due - 1)));
        of_area.see(double(std::abs(direct_light(m, Color(1), {to_light, 1, 1}, n, to_viewer).x / due - 1)));
    }
    figure(46, "phong, relative", of_phong.value, 1e-10);
    figure(46, "direct_light, relative", of_area.value, 1e-10);
}

TEST_CASE("47 lobes of exponent 1 to 1e12: sine, cosine and density relative 8u", "[extremes]") {
    Random random(47);
    Greatest sine, cosine, density;  // a broad lobe's logarithm l = log(u.x)/(n + 1) is large far from the axis
    for (int k = 0; k < 200000; ++k) {
        const Real exponent = k % 2 ? 1e8 : random.scale(1, 1e12);
        const vec2 u{random.scale(1e-12, 1), random.number()};
        const DirectionSample lobe = phong_lobe(exponent, u);
        const long double l = std::log((long double)(u.x)) / (exponent + 1.0L);
        const Long d(lobe.direction);
        sine.see(double(std::abs(std::sqrt(d.x * d.x + d.y * d.y) / std::sqrt(-std::expm1(2 * l)) - 1)) / roundoff);
        const Real u_of_l = roundoff * (1 + std::abs(double(l)));
        cosine.see(double(std::abs(d.z / std::exp(l) - 1)) / u_of_l);
        density.see(double(std::abs(lobe.density / ((exponent + 1.0L) / (2 * exact_pi) * std::exp(exponent * l)) - 1)) /
                    u_of_l);
    }
    figure(47, "sine of a lobe's angle, relative, in u", sine.value, 8);
    figure(47, "cosine, relative, in u(1 + |l|), |l| < 3e-7 at n = 1e8", cosine.value, 8);
    figure(47, "density, relative, in u(1 + |l|)", density.value, 8);
}

TEST_CASE("48 the lobe narrows into the mirror as n^-1/2", "[extremes]") {
    Random random(48);
    Greatest glossy, clear, heavy;
    for (Real exponent = 1e2; exponent <= 1e14; exponent *= 10) {
        Sum squares, squares_clear;
        const int n = 2000;
        for (int k = 0; k < n; ++k) {
            const vec3 normal = random.direction(), d = -random.direction_about(normal, 0.3);
            const vec2 u = random.point();
            const Scattered mirror = glossy_reflection(d, normal, exponent, u),
                            glass = translucency(d, normal, 1, 1.5, exponent, u);
            squares.add(double(2 * one_minus_cosine(mirror.direction, mirror_direction(d, normal))));
            squares_clear.add(double(2 * one_minus_cosine(glass.direction, refracted_direction(d, normal, 1, 1.5))));
            heavy.see(mirror.weight.x - (exponent + 2) / (exponent + 1));
        }
        // The mean squared angle of the lobe is 2/(n + 2).
        glossy.see(std::sqrt(squares.value() / n * exponent / 2));
        clear.see(std::sqrt(squares_clear.value() / n * exponent / 2));
    }
    figure(48, "angle to the mirror direction, root of its mean square, in sqrt(2/n)", glossy.value, 1.1);
    figure(48, "angle to the refracted direction, likewise", clear.value, 1.1);
    CHECK(heavy.value <= 8 * roundoff);
}

TEST_CASE("49 towards the critical angle, to 1e-15: the cosine behind to 8u/delta, and R + T = 1", "[extremes]") {
    Random random(49);
    Greatest squared, share, length;
    for (int k = 0; k < 200000; ++k) {
        const Real from = random.between(1.1, 3), to = random.between(1, from - 0.05),
                   delta = random.scale(1e-15, 1e-2);
        const Real critical = std::asin(to / from), angle = critical - delta;
        const vec3 n = vec3(0, 0, 1);
        const vec3 d{std::sin(angle), 0, -std::cos(angle)};
        const vec3 t = refracted_direction(d, n, from, to);
        const long double e = (long double)(from) / to, c = d.z, due = 1 - e * e * (1 - c * c);
        if (due <= 0) continue;
        const long double from_critical = due / (2 * std::sqrt((e - 1) * (e + 1)));  // delta, as the rounded d has it
        INFO("indices " << from << ", " << to << ", delta " << delta);
        if (t == vec3(0)) {
            CHECK(due <= 16 * roundoff);
            continue;
        }
        squared.see(double(std::abs((long double)(t.z) * t.z / due - 1) * from_critical) / roundoff);
        length.see(double(std::abs(exact_length(Long(t)) - 1)) / roundoff);
        // Stokes: the light that goes back the way it came is reflected as much.
        const Real r = fresnel_dielectric(-d.z, from, to), back = fresnel_dielectric(-t.z, to, from);
        CHECK((r >= 0 && r <= 1));
        share.see(std::abs(r - back));
        const Outgoing out = whitted(Material{.reflectance = Color(1), .transmittance = Color(1)}, r);
        CHECK(std::abs(out.mirror.x + out.glass.x - 1) <= 2 * roundoff);
    }
    figure(49, "squared cosine behind the surface, relative, in u/delta", squared.value, 8);
    figure(49, "length of the refracted direction off by, in u", length.value, 16);
    figure(49, "reflectance there and back, difference", share.value, 1e-7);
}

TEST_CASE("50 grazing incidence to 1e-9 and beyond: R goes to 1, without NaN", "[extremes]") {
    for (const Real to : {1.0 + 1e-9, 1.5, 3.0, 1e6})
        for (Real c = 1e-2; c > 1e-300; c /= 10) {
            // 1 - R = 4 c (s + 1/s) / ... : to first order R = 1 - 2 c (1/r + e^2/r), r = sqrt(e^2 - 1)
            const long double e = to, root = std::sqrt((e - 1) * (e + 1)), slope = 2 * (1 + e * e) / root;
            const Real r = fresnel_dielectric(c, 1, to);
            INFO("cosine " << c << ", index " << to << ": R " << r);
            CHECK((r >= 0 && r <= 1));
            if (slope * c < 1e-3)
                CHECK(std::abs((1 - r) - double(slope * c)) <= 2 * double(slope * slope) * c * c + 4 * roundoff);
            const vec3 d{std::sqrt(1 - c * c), 0, -c}, t = refracted_direction(d, {0, 0, 1}, 1, to);
            CHECK(std::isfinite(dot(t, t)));
            CHECK(t.z < 0);
        }
    CHECK(fresnel_dielectric(0, 1, 1.5) == 1);
    CHECK(fresnel_dielectric(0, 1.5, 1) == 1);
}

TEST_CASE("51 equal indices, and equal to 1e-12: the ray does not bend", "[extremes]") {
    Random random(51);
    Greatest bent, slightly;
    for (int k = 0; k < 200000; ++k) {
        const vec3 n = random.direction();
        const Frame frame = frame_about(n);
        const Real c = k % 2 ? random.scale(1e-9, 1) : random.number();
        const vec3 d = unit(std::sqrt(1 - c * c) * frame.x - c * n);
        const Real ior = random.between(1, 3);
        bent.see(largest(refracted_direction(d, n, ior, ior) - d) / roundoff);
        CHECK(fresnel_dielectric(c, ior, ior) == 0);
        // Snell: the angle changes by tan(theta) de/e.
        for (const Real e : {1e-12, -1e-12}) {
            const vec3 t = refracted_direction(d, n, ior, ior * (1 + e));
            if (c > 1e-3) slightly.see(largest(t - d) * c / 1e-12);
            CHECK(std::isfinite(dot(t, t)));
        }
    }
    figure(51, "equal indices: bend, in u", bent.value, 2);
    figure(51, "indices equal to 1e-12: bend, in 1e-12 tan(theta)", slightly.value, 1.1);
}

TEST_CASE("56 f(a, b) = f(b, a), for what a surface reflects and for what glass lets through", "[extremes]") {
    Random random(56);
    Greatest highlight, lobe;
    for (int k = 0; k < 200000; ++k) {
        const vec3 n = random.direction(), a = random.direction_about(n), b = random.direction_about(n);
        Material m;
        m.specular = Color(1);
        m.shininess = random.scale(1, 1e4);
        // Phong's term is symmetric as it stands; Lambert's after its cosine is taken out.
        const Real there = phong(m, Color(0), Color(1), n, a, b).x, back = phong(m, Color(0), Color(1), n, b, a).x;
        const Real along = dot(mirror_direction(-a, n), b);
        if (there > 1e-200) highlight.see(std::abs(there / back - 1) / (roundoff * (1 + m.shininess / along)));
        m.specular = Color(0), m.albedo = Color(0.7);
        const Real lambert = phong(m, Color(0), Color(1), n, a, b).x / dot(n, a);
        CHECK(std::abs(lambert / (phong(m, Color(0), Color(1), n, b, a).x / dot(n, b)) - 1) < 8 * roundoff);

        // The glossy lobe: weight x density / cosine is its BRDF, of the angle to the mirror direction alone.
        const Real exponent = random.scale(1, 1e4);
        const vec2 u = random.point();
        const Scattered way = glossy_reflection(-a, n, exponent, u);
        if (way.weight.x == 0) continue;
        const auto brdf = [&](vec3 in, vec3 out) {
            const vec3 off = mirror_direction(-in, n) - out;
            return (exponent + 2) / (2 * pi) * std::exp(exponent * std::log1p(-dot(off, off) / 2));
        };
        const Real density = phong_lobe(exponent, u).density, f = way.weight.x * density / dot(way.direction, n);
        lobe.see(std::abs(f / brdf(way.direction, a) - 1) /
                 (roundoff * (1 + exponent / dot(mirror_direction(-a, n), way.direction))));
    }
    figure(56, "highlight, light and viewer changed places, relative, in u(1 + n/cos)", highlight.value, 32);
    figure(56, "glossy lobe against its BRDF backwards, relative, in u(1 + n/cos)", lobe.value, 32);
}

TEST_CASE("67 arguments that rounding pushed past their limits: clamped, no NaN", "[extremes]") {
    const Real over = 1 + 2 * roundoff, under = 1 - roundoff;
    CHECK(safe_sqrt(-roundoff) == 0);
    CHECK(safe_sqrt(-0.0) == 0);
    for (const Real c : {over, under, 1.0}) {
        CHECK(std::isfinite(fresnel_dielectric(c, 1, 1.5)));
        CHECK(std::isfinite(fresnel_dielectric(c, 1.5, 1)));
        for (const Real e : {0.5, 1.0, 1.5}) {
            const vec3 t = refracted_direction({0, 0, -c}, {0, 0, 1}, 1, e);
            CHECK(std::isfinite(dot(t, t)));
        }
        const DirectionSample cone = sphere_cone(c, {0.5, 0.5});
        CHECK(std::isfinite(cone.density + dot(cone.direction, cone.direction)));
        Material m;
        m.specular = m.albedo = Color(1);
        m.shininess = 1e9;
        CHECK(std::isfinite(phong(m, Color(0), Color(1), {0, 0, 1}, {0, 0, c}, {0, 0, c}).x));
        CHECK(std::isfinite(phong(m, Color(0), Color(1), {0, 0, 1}, {0, 0, c}, {0, 0, -c}).x));
        const Scattered way = translucency({0, 0, -c}, {0, 0, 1}, 1.5, 1, 1e9, {below_one, 0.5});
        CHECK(std::isfinite(way.weight.x + dot(way.direction, way.direction)));
        const vec3 back = glossy_reflection({0, 0, -c}, {0, 0, 1}, 1e9, {0, 0}).direction;
        CHECK(std::isfinite(dot(back, back)));
    }
}
