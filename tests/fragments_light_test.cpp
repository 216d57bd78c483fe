#include "catch.h"
#include "random.h"
#include "rt/fragments.h"
#include "statistics/closed_forms.h"
#include "warp.h"

using namespace rt;

namespace {

using Kind = Emitter::Kind;

constexpr Kind kinds[] = {Kind::quad, Kind::disc, Kind::sphere};

/// A light about one metre wide, some distance away from the origin, that shines on it.
Emitter random_light(Kind kind, Real distance, Random& random) {
    const vec3 center = distance * random.direction();
    const vec3 normal = random.direction_about(unit(-center), 0.2);
    const Frame frame = frame_about(normal);
    Emitter light;
    light.kind = kind;
    light.quad = {center, random.between(0.2, 1) * frame.x, random.between(0.2, 1) * frame.y};
    light.disc = {center, normal, random.between(0.2, 1)};
    light.sphere = {center, random.between(0.2, 1)};
    return light;
}

std::string described(const Emitter& light) {
    static const char* names[] = {"quad", "disc", "sphere"};
    return std::string(names[int(light.kind)]) + " at " + text(center(light));
}

/// What all samples of a light together say about the irradiance at p, for radiance 1.
Real irradiance(const Emitter& light, vec3 p, vec3 n) {
    return square_mean(300, [&](vec2 u) {
        const LightSample sample = light_sample(light, p, u);
        const Real cosine = dot(n, sample.direction);
        return sample.density > 0 && cosine > 0 ? cosine / sample.density : 0.0;
    });
}

}  // namespace

TEST_CASE("light_sample: direction and distance lead to a point of the light") {
    Random random(1);
    for (int i = 0; i < 3000; ++i) {
        const Emitter light = random_light(kinds[i % 3], random.scale(2, 1000), random);
        const vec3 p = 0.5 * random.in_cube();
        const LightSample sample = light_sample(light, p, random.point());
        if (sample.density == 0) continue;
        const vec3 point = p + sample.distance * sample.direction;
        const Real far = sample.distance * 1e-12;
        INFO(described(light) << " from " << text(p) << ", sample " << text(point));
        CHECK(dot(sample.direction, sample.direction) == Approx(1).epsilon(1e-13));
        if (light.kind == Kind::quad) {
            const vec3 q = point - light.quad.center;
            CHECK(std::abs(dot(q, light.disc.normal)) < far);
            CHECK(std::abs(dot(q, light.quad.u)) <= dot(light.quad.u, light.quad.u) + far);
            CHECK(std::abs(dot(q, light.quad.v)) <= dot(light.quad.v, light.quad.v) + far);
        } else if (light.kind == Kind::disc) {
            const vec3 q = point - light.disc.center;
            CHECK(std::abs(dot(q, light.disc.normal)) < far);
            CHECK(std::sqrt(dot(q, q)) <= light.disc.radius + far);
        } else {
            const vec3 q = point - light.sphere.center;
            CHECK(std::sqrt(dot(q, q)) == Approx(light.sphere.radius).margin(1e-6));  // a tangent loses half the digits
            CHECK(dot(q, sample.direction) <= 1e-6);                                  // the near half
        }
    }
}

TEST_CASE("light_sample: from the very point that is drawn, and from a sphere's centre, no light and finite numbers") {
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const Emitter light = random_light(kinds[i % 3], random.scale(2, 1000), random);
        const vec2 u = light.kind == Kind::quad ? vec2(0.5) : vec2(0, random.number());
        const LightSample sample = light_sample(light, center(light), u);
        INFO(described(light));
        CHECK(sample.density == 0);
        CHECK((std::isfinite(sample.distance) && std::isfinite(dot(sample.direction, sample.direction))));
    }
}

TEST_CASE("light_sample: the density is one over the stretch of solid angle") {
    Random random(2);
    for (int i = 0; i < 600; ++i) {
        const Emitter light = random_light(kinds[i % 3], random.scale(2, 20), random);
        const vec2 u = 0.01 + 0.98 * random.point();
        const auto direction = [&](vec2 v) { return light_sample(light, vec3(0), v).direction; };
        INFO(described(light) << ", u " << text(u));
        CHECK(light_sample(light, vec3(0), u).density * area_stretch(direction, u) == Approx(1).epsilon(1e-3));
    }
}

TEST_CASE("light_sample: irradiance of a quad is Lambert's formula") {
    Random random(3);
    for (int i = 0; i < 20; ++i) {
        Emitter light = random_light(Kind::quad, random.between(2, 10), random);
        const vec3 n = unit(unit(light.quad.center) + 0.5 * random.in_cube());  // wholly above the horizon
        if (dot(n, unit(light.quad.center)) < 0.8) continue;
        INFO(described(light) << ", n " << text(n));
        CHECK(irradiance(light, vec3(0), n) == Approx(grade::quad_irradiance(light.quad, vec3(0), n)).epsilon(1e-3));
    }
}

TEST_CASE("light_sample: irradiance of a coaxial disc is pi r^2 / (r^2 + h^2), from near to far away") {
    for (const Real height : {0.5, 1.0, 10.0, 1e3, 1e6}) {
        Emitter light;
        light.kind = Kind::disc;
        light.disc = {{0, 0, height}, {0, 0, -1}, 1.5};
        INFO("height " << height);
        CHECK(irradiance(light, vec3(0), {0, 0, 1}) ==
              Approx(grade::coaxial_disc_irradiance(1.5, height)).epsilon(1e-3));
    }
}

TEST_CASE("light_sample: irradiance of a sphere above the horizon is pi (R/d)^2 cos, from touching to far away") {
    for (const Real distance : {1.0001, 1.5, 3.0, 100.0, 1e6, 1e9}) {
        Emitter light;
        light.kind = Kind::sphere;
        light.sphere = {{0, 0, distance}, 1};
        INFO("distance " << distance);
        CHECK(irradiance(light, vec3(0), {0, 0, 1}) == Approx(pi / sqr(distance)).epsilon(1e-3));
        const vec3 tilted = unit({1, 0, 2});
        if (distance > 3)
            CHECK(irradiance(light, vec3(0), tilted) == Approx(pi / sqr(distance) * tilted.z).epsilon(1e-3));
    }
}

TEST_CASE("light_sample: a flat light shines from its front alone, a sphere from its outside alone") {
    Random random(4);
    for (int i = 0; i < 600; ++i) {
        Emitter light = random_light(kinds[i % 3], 5, random);
        light.quad.u = -light.quad.u;  // turns it round
        light.disc.normal = -light.disc.normal;
        const vec3 p = light.kind == Kind::sphere
                           ? light.sphere.center + 0.99 * light.sphere.radius * random.direction()
                           : vec3(0);
        INFO(described(light));
        CHECK(light_sample(light, p, random.point()).density == 0);
    }
}

TEST_CASE("light_sample: in a scene of another size distances scale and densities stay") {
    Random random(5);
    for (int i = 0; i < 600; ++i) {
        const Emitter light = random_light(kinds[i % 3], 4, random);
        const Real scale = random.scale(1e-6, 1e6);
        Emitter scaled = light;
        scaled.quad = {scale * light.quad.center, scale * light.quad.u, scale * light.quad.v};
        scaled.disc = {scale * light.disc.center, light.disc.normal, scale * light.disc.radius};
        scaled.sphere = {scale * light.sphere.center, scale * light.sphere.radius};
        const vec2 u = random.point();
        const LightSample a = light_sample(light, vec3(0), u), b = light_sample(scaled, vec3(0), u);
        INFO(described(light) << " scaled by " << scale << ", u " << text(u));
        CHECK(b.density == Approx(a.density).epsilon(1e-9));
        CHECK(b.distance == Approx(scale * a.distance).epsilon(1e-6));
    }
}

TEST_CASE("direct_light: what phong gives for the irradiance radiance / density") {
    Random random(6);
    Material material;
    material.albedo = {0.5, 0.6, 0.7};
    material.specular = {0.4, 0.3, 0.2};
    material.shininess = 15;
    for (int i = 0; i < 2000; ++i) {
        const vec3 n = random.direction(), d = random.direction(), viewer = random.direction_about(n);
        const LightSample sample{d, random.scale(0.1, 10), random.scale(1e-3, 1e3)};
        const Color radiance(1, 2, 3);
        const Color got = direct_light(material, radiance, sample, n, viewer);
        const Color other = phong(material, Color(0), radiance / sample.density, n, d, viewer);
        INFO("n " << text(n) << ", light " << text(d) << ", viewer " << text(viewer));
        CHECK(got.x == Approx(other.x).epsilon(1e-12));
        CHECK(got.z == Approx(other.z).epsilon(1e-12));
        if (dot(n, d) < 0) CHECK(got == Color(0));
    }
}

TEST_CASE("direct_light: nothing, and no NaN, where the light does not shine") {
    Material material;
    material.albedo = material.specular = Color(1);
    const vec3 n(0, 0, 1);
    CHECK(direct_light(material, Color(1e300), {n, 1, 0}, n, n) == Color(0));
    CHECK(direct_light(material, Color(1), {vec3(0), 0, 0}, n, n) == Color(0));
}
