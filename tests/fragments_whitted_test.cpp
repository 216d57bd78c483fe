#include "catch.h"
#include "random.h"
#include "rt/fragments.h"
#include "warp.h"

using namespace rt;

namespace {

Material shiny() {
    Material material;
    material.ambient = {0.1, 0.2, 0.3};
    material.albedo = {0.5, 0.6, 0.7};
    material.specular = {0.4, 0.3, 0.2};
    material.shininess = 20;
    return material;
}

Real sine_between(vec3 a, vec3 b) {
    const vec3 c = cross(a, b);
    return std::sqrt(dot(c, c));
}

}  // namespace

TEST_CASE("point_irradiance: I / r^2 for a surface that faces the light, times the cosine for others, 0 from behind") {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const vec3 n = random.direction(), p = random.in_cube(), d = random.direction();
        const Real r = random.scale(1e-3, 1e4), cosine = dot(n, d);
        const PointLight light{p + r * d, {1, 2, 3}, false};
        INFO("n " << text(n) << ", to the light " << text(r * d));
        const Color got = point_irradiance(light, p, n);
        if (cosine < -1e-9) CHECK(got == Color(0));
        if (cosine > 0.01) {
            CHECK(got.x == Approx(cosine / (r * r)).epsilon(1e-9));
            CHECK(got.z == Approx(3 * got.x).epsilon(1e-12));
        }
    }
}

TEST_CASE("point_irradiance: a directional light is the limit of a point light far away") {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const vec3 d = random.direction(), n = random.direction(), p = random.in_cube();
        const Real far = 1e9;
        const Color limit = point_irradiance({far * d, Color(5 * far * far), false}, p, n);
        INFO("n " << text(n) << ", d " << text(d));
        CHECK(point_irradiance({d, Color(5), true}, p, n).x == Approx(limit.x).margin(1e-7));
    }
}

TEST_CASE("phong: the hemisphere gets albedo times the irradiance back from a Lambertian surface") {
    Material material;
    material.albedo = {0.2, 0.5, 0.9};
    const vec3 n(0, 0, 1), to_light = unit({0.3, 0.4, 0.5});
    const Real cosine = to_light.z;
    const Color reflected = square_mean(200, [&](vec2 u) {
        const vec3 viewer(std::sqrt(1 - u.x * u.x) * unit_circle(u.y), u.x);  // uniform on the hemisphere
        return phong(material, Color(0), Color(3), n, to_light, viewer) * u.x * 2.0 * pi;
    });
    CHECK(reflected.x == Approx(0.2 * 3 * cosine).epsilon(1e-4));
    CHECK(reflected.z == Approx(0.9 * 3 * cosine).epsilon(1e-4));
}

TEST_CASE(
    "phong: the highlight is r_s in the mirror direction, and falls as the cosine to the power of the shininess") {
    Material material = shiny();
    material.albedo = material.ambient = Color(0);
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const vec3 n = random.direction(), d = random.direction_about(n), peak = 2 * dot(n, d) * n - d;
        const Frame frame = frame_about(peak);
        const Real angle = random.between(0, 1.5);
        const vec3 viewer = std::cos(angle) * peak + std::sin(angle) * frame.x;
        INFO("n " << text(n) << ", d " << text(d) << ", viewer at " << angle << " from the mirror direction");
        CHECK(phong(material, Color(1), Color(2), n, d, viewer).y ==
              Approx(2 * 0.3 * std::pow(std::cos(angle), 20)).margin(1e-12));
    }
}

TEST_CASE("phong: ambient light alone where the light is below the horizon; linear in the irradiance") {
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const vec3 n = random.direction(), d = random.direction_about(n), viewer = random.direction_about(n);
        INFO("n " << text(n) << ", d " << text(d) << ", viewer " << text(viewer));
        CHECK(phong(shiny(), Color(2), Color(7), n, -d, viewer) == shiny().ambient * 2.0);
        const Color once = phong(shiny(), Color(0), Color(1), n, d, viewer),
                    thrice = phong(shiny(), Color(0), Color(3), n, d, viewer);
        CHECK(thrice.x == Approx(3 * once.x).epsilon(1e-13));
    }
}

TEST_CASE("shadow_ray: towards the light, from the light's side of the surface, and not as far as the light") {
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Hit hit{random.vector(1e-3, 1e6), random.direction(), random.scale(1e-16, 1e-9)};
        const vec3 d = random.direction();
        const Real distance = random.scale(1e-6, 1e9);
        const Ray ray = shadow_ray(hit, d, distance);
        INFO("point " << text(hit.point) << ", distance " << distance);
        CHECK(ray.direction == d);
        CHECK(ray.near >= 0);
        CHECK(ray.far < distance);
        CHECK(ray.far > 0.999 * distance);
        CHECK(dot(ray.origin - hit.point, hit.normal) * dot(d, hit.normal) >= 0);
        CHECK(shadow_ray(hit, d, inf).far == inf);
    }
}

TEST_CASE("mirror_direction: as long as d, the same angle on the other side, in one plane, and back again") {
    Random random(6);
    for (int i = 0; i < 2000; ++i) {
        const vec3 n = random.direction(), d = random.vector(0.1, 10), r = mirror_direction(d, n);
        INFO("d " << text(d) << ", n " << text(n));
        CHECK(dot(r, r) == Approx(dot(d, d)).epsilon(1e-13));
        CHECK(dot(r, n) == Approx(-dot(d, n)).margin(1e-13));
        CHECK(dot(r, cross(d, n)) == Approx(0).margin(1e-13));
        CHECK(dot(mirror_direction(r, n), d) == Approx(dot(d, d)).epsilon(1e-13));
    }
}

TEST_CASE(
    "refracted_direction: Snell's law, unit length, in one plane, on the other side, and the way back; zero when "
    "total") {
    Random random(7);
    int total = 0;
    for (int i = 0; i < 5000; ++i) {
        const vec3 n = random.direction(), d = -random.direction_about(n);
        const Real from = random.between(1, 2.5), to = random.between(1, 2.5);
        const vec3 t = refracted_direction(d, n, from, to);
        const Real sine = sine_between(d, n) * from / to;
        INFO("d " << text(d) << ", n " << text(n) << ", from " << from << " to " << to);
        if (std::abs(sine - 1) < 1e-6) continue;
        if (sine > 1) {
            CHECK(t == vec3(0));
            ++total;
            continue;
        }
        CHECK(dot(t, t) == Approx(1).epsilon(1e-12));
        CHECK(sine_between(t, n) == Approx(sine).margin(1e-9));
        CHECK(dot(t, n) < 0);
        CHECK(dot(t, cross(d, n)) == Approx(0).margin(1e-13));
        CHECK(dot(refracted_direction(-t, -n, to, from), -d) == Approx(1).epsilon(1e-9));
        CHECK(dot(refracted_direction(d, n, from, from), d) == Approx(1).epsilon(1e-13));
    }
    CHECK(total > 100);
}

TEST_CASE("fresnel_dielectric: normal incidence, grazing, total, Brewster's angle, equal indices") {
    Random random(8);
    for (int i = 0; i < 2000; ++i) {
        const Real a = random.between(1, 3), b = random.between(1, 3);
        if (std::abs(a - b) < 0.01) continue;
        INFO("from " << a << " to " << b);
        CHECK(fresnel_dielectric(1, a, b) == Approx(sqr((a - b) / (a + b))).epsilon(1e-10));
        CHECK(fresnel_dielectric(1e-9, a, b) == Approx(1).margin(1e-6));
        CHECK(fresnel_dielectric(random.number(), a, a) == 0);
        if (a > b) CHECK(fresnel_dielectric(0.999 * std::sqrt(1 - sqr(b / a)), a, b) == 1);
        const Real brewster = std::cos(std::atan(b / a)), refracted = std::sin(std::atan(b / a));  // at right angles
        CHECK(fresnel_dielectric(brewster, a, b) ==
              Approx(sqr((a * brewster - b * refracted) / (a * brewster + b * refracted)) / 2).margin(1e-12));
    }
}

TEST_CASE("fresnel_dielectric: a share, and the same both ways") {
    Random random(9);
    for (int i = 0; i < 5000; ++i) {
        const Real a = random.between(1, 3), b = random.between(1, 3), cosine = random.number();
        INFO("cosine " << cosine << ", from " << a << " to " << b);
        const Real share = fresnel_dielectric(cosine, a, b);
        CHECK((share >= 0 && share <= 1));
        const Real squared = 1 - sqr(a / b) * (1 - cosine * cosine);
        if (squared > 1e-6) CHECK(fresnel_dielectric(std::sqrt(squared), b, a) == Approx(share).margin(1e-7));
    }
}

TEST_CASE(
    "whitted: opaque surfaces mirror their reflectance; lossless glass keeps all light; coloured glass by channel") {
    Material mirror;
    mirror.reflectance = {0.9, 0.5, 0.1};
    const Outgoing opaque = whitted(mirror, 0.3);
    CHECK((opaque.local == Color(1) && opaque.mirror == mirror.reflectance && opaque.glass == Color(0)));

    Material glass;
    glass.reflectance = glass.transmittance = Color(1);
    for (const Real fresnel : {0.0, 0.04, 0.7, 1.0}) {
        const Outgoing both = whitted(glass, fresnel);
        CHECK(both.mirror.x == Approx(fresnel));
        CHECK(both.mirror.x + both.glass.x == Approx(1).epsilon(1e-15));
    }
    glass.transmittance = {0, 0, 0.5};  // blue alone: still glass
    const Outgoing blue = whitted(glass, 0.25);
    CHECK((blue.glass.x == 0 && blue.glass.z == Approx(0.375) && blue.mirror.x == Approx(0.25)));
}
