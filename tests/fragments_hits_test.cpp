#include "catch.h"
#include "random.h"
#include "rt/fragments.h"

using namespace rt;

namespace {

using Long = glm::tvec3<long double>;

long double length(Long v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

Long at(const Ray& ray, Real t) { return Long(ray.origin) + (long double)(t)*Long(ray.direction); }

/// A ray from some distance to a target, with a direction of any length.
Ray ray_to(vec3 target, Real distance, Random& random) {
    const vec3 direction = random.direction();
    const Real length = random.scale(1e-3, 1e3);
    return {target - distance * direction, length * direction, 0, inf};
}

}  // namespace

TEST_CASE("camera_ray: unit directions; the middle of the film looks along the axis; corners span the field of view") {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Frame frame = frame_about(random.direction());
        Camera camera;
        camera.eye = 10.0 * random.in_cube();
        camera.right = frame.x, camera.up = frame.y, camera.back = frame.z;
        camera.tan_half_fov = random.between(0.05, 2);
        camera.size = {random.integer(1, 500), random.integer(1, 500)};
        INFO("size " << camera.size.x << " x " << camera.size.y << ", tan_half_fov " << camera.tan_half_fov);

        const Ray middle = camera_ray(camera, 0.5 * vec2(camera.size));
        CHECK(middle.origin == camera.eye);
        CHECK((middle.near == 0 && middle.far == inf));
        CHECK(dot(middle.direction, -camera.back) == Approx(1).epsilon(1e-14));

        const vec3 top = camera_ray(camera, {0.5 * camera.size.x, 0}).direction;
        CHECK(dot(top, top) == Approx(1).epsilon(1e-14));
        CHECK(dot(top, camera.up) / -dot(top, camera.back) == Approx(camera.tan_half_fov).epsilon(1e-12));
        const vec3 side = camera_ray(camera, {camera.size.x, 0.5 * camera.size.y}).direction;
        const Real aspect = Real(camera.size.x) / camera.size.y;
        CHECK(dot(side, camera.right) / -dot(side, camera.back) == Approx(aspect * camera.tan_half_fov).epsilon(1e-12));
        CHECK(dot(side, camera.up) == Approx(0).margin(1e-14));
    }
}

TEST_CASE("hit_sphere: a ray towards a point inside hits the surface, small, huge, near and far away") {
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        const Sphere sphere{random.vector(1e-3, 1e6), random.scale(1e-6, 1e6)};
        const Real distance = sphere.radius * random.scale(1.01, 1e6);
        const vec3 target = sphere.center + sphere.radius * random.vector(0.01, 0.99);
        const Ray ray = ray_to(target, distance, random);
        INFO("center " << text(sphere.center) << ", radius " << sphere.radius << ", origin " << text(ray.origin)
                       << ", direction " << text(ray.direction));
        const Long f = Long(ray.origin) - Long(sphere.center);
        if (length(f) < 1.01L * sphere.radius) continue;  // starts too near to say on which side
        // rounding of origin and target has moved the ray itself
        const long double rounding = 1e-15L * (length(f) + length(Long(sphere.center)));
        if (rounding > 1e-3L * sphere.radius) continue;

        const Real t = hit_sphere(sphere, ray);
        REQUIRE(t < inf);
        REQUIRE(t > 0);
        const long double off = std::abs(length(at(ray, t) - Long(sphere.center)) - sphere.radius);
        CHECK(double(off) <= double(4 * rounding));
        const Long outwards = at(ray, t) - Long(sphere.center);
        CHECK(outwards.x * ray.direction.x + outwards.y * ray.direction.y + outwards.z * ray.direction.z <
              0);  // the near root
    }
}

TEST_CASE("hit_sphere: misses what it should miss, and what lies behind") {
    Random random(3);
    for (int i = 0; i < 5000; ++i) {
        const Sphere sphere{10.0 * random.in_cube(), random.scale(0.01, 10)};
        const vec3 n = random.direction();
        const vec3 along = frame_about(n).x * random.scale(0.01, 100);
        const vec3 beside = sphere.center + (1 + random.scale(1e-6, 10)) * sphere.radius * n;
        INFO("center " << text(sphere.center) << ", radius " << sphere.radius << ", through " << text(beside));
        CHECK(hit_sphere(sphere, {beside - random.between(-5, 5) * along, along, 0, inf}) == inf);
        const vec3 away = random.direction_about(n);
        CHECK(hit_sphere(sphere, {beside, away, 0, inf}) == inf);
    }
}

TEST_CASE("hit_sphere: from inside the far root; only what lies inside the ray's interval") {
    const Sphere sphere{{0, 0, 5}, 2};
    CHECK(hit_sphere(sphere, {{0, 0, 5}, {0, 0, 1}, 0, inf}) == Approx(2));
    CHECK(hit_sphere(sphere, {{0, 0, 0}, {0, 0, 2}, 0, inf}) == Approx(1.5));
    CHECK(hit_sphere(sphere, {{0, 0, 0}, {0, 0, 1}, 4, inf}) == Approx(7));
    CHECK(hit_sphere(sphere, {{0, 0, 0}, {0, 0, 1}, 4, 6}) == inf);
    CHECK(hit_sphere(sphere, {{0, 0, 0}, {0, 0, 1}, 0, 2.9}) == inf);
    CHECK(hit_sphere(sphere, {{0, 0, 0}, {0, 0, 1}, 7.1, inf}) == inf);
    CHECK(hit_sphere(sphere, {{0, 0, 10}, {0, 0, 1}, 0, inf}) == inf);
}

TEST_CASE("hit_triangle: where a point has positive barycentric coordinates, from both sides, at any scale") {
    Random random(4);
    for (int i = 0; i < 20000; ++i) {
        const Real scale = random.scale(1e-6, 1e6);
        const Triangle triangle{scale * random.in_cube(), scale * random.in_cube(), scale * random.in_cube()};
        const vec3 normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
        const Real area = std::sqrt(dot(normal, normal));
        if (area < 0.05 * scale * scale) continue;
        const Real v = random.between(-0.5, 1.5), w = random.between(-0.5, 1.5), u = 1 - v - w;
        const Real edge = std::min(u, std::min(v, w));
        if (std::abs(edge) < 1e-6) continue;
        const Real distance = scale * random.scale(0.1, 1e3);
        const Ray ray = ray_to(u * triangle.a + v * triangle.b + w * triangle.c, distance, random);
        if (std::abs(dot(unit(ray.direction), normal)) < 0.02 * area) continue;  // grazing
        INFO("scale " << scale << ", barycentric " << u << " " << v << " " << w << ", distance " << distance);

        const Real t = hit_triangle(triangle, ray);
        if (edge < 0) {
            CHECK(t == inf);
            continue;
        }
        REQUIRE(t < inf);
        const Long p = at(ray, t) - Long(triangle.a), n = Long(normal) / (long double)(area);
        CHECK(double(std::abs(p.x * n.x + p.y * n.y + p.z * n.z)) <= 1e-13 * (distance + scale) / 0.02);
        CHECK(hit_triangle(triangle, {ray.origin, ray.direction, t * 1.001, inf}) == inf);
        CHECK(hit_triangle(triangle, {ray.origin, ray.direction, 0, t * 0.999}) == inf);
        CHECK(hit_triangle(triangle, {ray.origin, -ray.direction, 0, inf}) == inf);
    }
}

TEST_CASE("hit_triangle: no ray passes between two triangles that share an edge or a corner") {
    Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const vec3 hub = random.in_cube();
        vec3 rim[5];
        for (int k = 0; k < 5; ++k)
            rim[k] = hub + vec3(std::cos(2 * pi * k / 5), std::sin(2 * pi * k / 5), 0.3 * random.between(-1, 1));
        const vec3 target = random.integer(0, 1) ? hub : hub + random.number() * 0.9 * (rim[2] - hub);
        const vec3 eye = hub + vec3(2.0 * random.point() - 1.0, 10);
        const Ray ray{eye, target - eye, 0, inf};
        int hits = 0;
        for (int k = 0; k < 5; ++k) hits += hit_triangle({hub, rim[k], rim[(k + 1) % 5]}, ray) < inf;
        INFO("eye " << text(eye) << ", target " << text(target));
        CHECK(hits >= 1);
    }
}

TEST_CASE("hit_triangle: without area, never hit") {
    CHECK(hit_triangle({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0.5, 0, 1}, {0, 0, -1}, 0, inf}) == inf);
    CHECK(hit_triangle({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 0, 1}, {0, 0, -1}, 0, inf}) == inf);
}

TEST_CASE("hit_quad: inside its half edges, from both sides, at any scale") {
    Random random(6);
    for (int i = 0; i < 20000; ++i) {
        const Real scale = random.scale(1e-6, 1e6);
        const Frame frame = frame_about(random.direction());
        const Quad quad{scale * random.in_cube(), scale * random.between(0.1, 1) * frame.x,
                        scale * random.between(0.1, 1) * frame.y};
        const Real x = random.between(-1.5, 1.5), y = random.between(-1.5, 1.5);
        const Real outside = std::max(std::abs(x), std::abs(y)) - 1;
        const Real distance = scale * random.scale(0.1, 1e3);
        const Ray ray = ray_to(quad.center + x * quad.u + y * quad.v, distance, random);
        if (std::abs(outside) < 1e-6 || std::abs(dot(unit(ray.direction), frame.z)) < 0.02) continue;
        INFO("scale " << scale << ", x " << x << ", y " << y << ", distance " << distance);

        const Real t = hit_quad(quad, ray);
        CHECK((t < inf) == (outside < 0));
        if (t == inf) continue;
        const Long p = at(ray, t) - Long(quad.center), n(frame.z);
        CHECK(double(std::abs(p.x * n.x + p.y * n.y + p.z * n.z)) <= 1e-13 * (distance + scale) / 0.02);
        CHECK(hit_quad(quad, {ray.origin, ray.direction, t * 1.001, inf}) == inf);
        CHECK(hit_quad(quad, {ray.origin, ray.direction, 0, t * 0.999}) == inf);
    }
}

TEST_CASE("hit_quad: a ray in its plane misses") {
    const Quad quad;
    CHECK(hit_quad(quad, {{-3, 0, 0}, {1, 0, 0}, 0, inf}) == inf);
    CHECK(hit_quad(quad, {{-3, 0, 1}, {1, 0, 0}, 0, inf}) == inf);
}
