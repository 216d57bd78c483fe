/// No ray passes through a closed mesh: extremes.md 17, 18, 20 to 23.

#include "extremes/meshes.h"
#include "rt/fragments.h"
#include "rt/stages/stages.h"

using namespace rt;

namespace {

/// A point of the mesh: anywhere on a triangle, on an edge, or a vertex.
vec3 target_on(const Mesh& mesh, Random& random) {
    const auto t = mesh.triangles[std::size_t(random.integer(0, int(mesh.triangles.size()) - 1))];
    const vec3 a = mesh.vertices[std::size_t(t.x)], b = mesh.vertices[std::size_t(t.y)],
               c = mesh.vertices[std::size_t(t.z)];
    switch (random.integer(0, 2)) {
        case 0:
            return a;
        case 1:
            return a + random.number() * (b - a);
        default: {
            const vec2 u = random.point();
            return (1 - u.x) * a + u.x * ((1 - u.y) * b + u.y * c);
        }
    }
}

Mesh placed(Mesh mesh, Real scale, vec3 at) {
    for (vec3& v : mesh.vertices) v = at + scale * v;
    return mesh;
}

World world_of_mesh(const Mesh& mesh) {
    Scene scene = plain_scene();
    scene.meshes.push_back(mesh);
    return make_world(scene);
}

struct Missed {
    std::int64_t rays = 0, misses = 0;
};

/// Rays from the middle and through it, from outside, to points of the mesh: each must meet it.
void shoot(const World& world, const Mesh& mesh, vec3 middle, Real scale, int batches, Random& random, Missed& found) {
    for (int k = 0; k < batches; ++k) {
        Batch b{};
        b.count = lanes;
        for (int i = 0; i < lanes; ++i) {
            const vec3 target = target_on(mesh, random);
            switch (random.integer(0, 3)) {
                case 0:
                    b.set_ray(i, {middle, random.direction(), 0, inf});
                    break;
                case 1:
                    b.set_ray(i, {middle, target - middle, 0, inf});
                    break;
                case 2:
                    b.set_ray(i, {middle, unit(target - middle), 0, inf});
                    break;
                default: {
                    // From outside, and on to the middle.
                    const vec3 outwards = unit(target - middle), eye = target + random.scale(1, 1e3) * scale * outwards;
                    b.set_ray(i, {eye, unit(target - eye), 0, inf});
                }
            }
        }
        nearest_stage(world, b);
        found.rays += lanes;
        for (int i = 0; i < lanes; ++i) {
            if (b.shape[i] != nothing) continue;
            ++found.misses;
            UNSCOPED_INFO("origin " << text(b.ray(i).origin) << ", direction " << text(b.ray(i).direction) << ", scale "
                                    << scale);
        }
    }
}

}  // namespace

TEST_CASE("17 closed meshes, all directions, scales 2^-40 to 2^40: no ray gets through", "[extremes]") {
    Random random(17);
    for (const ClosedMesh& closed : closed_meshes()) {
        Missed found;
        const std::int64_t wanted = count_of(2e6, 2e7);
        const int scales = 27, batches = int(wanted / scales / lanes) + 1;
        for (int k = 0; k < scales; ++k) {
            const Real scale = power_of_two(k * 3 - 39 + (k == 0 ? -1 : k == 26 ? 1 : 0));
            const vec3 at = random.vector(0.1 * scale, 1e3 * scale);
            const Mesh mesh = placed(closed.mesh, scale, at);
            shoot(world_of_mesh(mesh), mesh, at + scale * closed.middle, scale, batches, random, found);
            if (found.misses > 0) break;
        }
        figure(17, closed.name + ": misses among " + std::to_string(found.rays) + " rays", double(found.misses), 0);
    }
}

TEST_CASE("21 a mesh at (148376, 1234, -223423) of radius 2", "[extremes]") {
    Random random(21);
    const vec3 at{148376, 1234, -223423};
    const Mesh mesh = placed(ball(4, 0.05, random), 2, at);
    Missed found;
    shoot(world_of_mesh(mesh), mesh, at, 2, int(count_of(1e6, 1e8) / lanes) + 1, random, found);
    figure(21, "misses among " + std::to_string(found.rays) + " rays", double(found.misses), 0);
}

TEST_CASE("17 18 two triangles with one edge: a ray at the edge meets one or both, whatever the order of the corners",
          "[extremes]") {
    Random random(18);
    std::int64_t misses = 0, rays = count_of(1e6, 1e7);
    for (std::int64_t k = 0; k < rays; ++k) {
        const vec3 p = random.in_cube(), q = random.in_cube();
        const vec3 middle = 0.5 * (p + q), eye = middle + random.vector(1e-2, 1e4);
        // Corners on both sides of the edge as the eye sees it.
        const vec3 across = unit(cross(q - p, eye - middle)), along = unit(eye - middle);
        const vec3 r = middle + random.between(0.01, 1) * across + random.between(-1, 1) * along;
        const vec3 s = middle - random.between(0.01, 1) * across + random.between(-1, 1) * along;
        const vec3 target = p + random.between(0.001, 0.999) * (q - p);
        const Ray ray{eye, target - eye, 0, inf};
        const bool one = hit_triangle(random.integer(0, 1) ? Triangle{p, q, r} : Triangle{r, p, q}, ray) < inf;
        const bool two = hit_triangle(random.integer(0, 1) ? Triangle{p, q, s} : Triangle{q, p, s}, ray) < inf;
        misses += !one && !two;
    }
    figure(18, "edges that let a ray through, of " + std::to_string(rays), double(misses), 0);
}

TEST_CASE("18 turned round, a triangle is hit at the same distance, bit by bit", "[extremes]") {
    Random random(18);
    std::int64_t different = 0;
    for (int k = 0; k < 1000000; ++k) {
        const vec3 a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
        const vec3 eye = random.vector(1, 1e3);
        const vec3 target = random.integer(0, 1) ? a + random.number() * (b - a) : (a + b + c) / 3.0;
        const Ray ray{eye, target - eye, 0, inf};
        different += hit_triangle({a, b, c}, ray) != hit_triangle({a, c, b}, ray);
    }
    figure(18, "triangles that differ from their back sides, of 1000000", double(different), 0);
}

TEST_CASE("20 axis-parallel rays meet the same thing with either zero", "[extremes]") {
    const Real zeros[] = {0.0, -0.0};
    Random random(20);
    const Mesh mesh = ball(2, 0.1, random);
    const World world = world_of_mesh(mesh);
    for (int axis = 0; axis < 3; ++axis)
        for (const Real sign : {-1.0, 1.0})
            for (int k = 0; k < 500; ++k) {
                vec3 eye = k < 100 ? mesh.vertices[std::size_t(k)] : 0.8 * random.in_cube();
                eye[axis] = -3 * sign;
                Real t = -1, ball_t = -1;
                for (const Real x : zeros)
                    for (const Real y : zeros) {
                        Batch b{};
                        b.count = 1;
                        vec3 d;
                        d[axis] = sign, d[(axis + 1) % 3] = x, d[(axis + 2) % 3] = y;
                        b.set_ray(0, {eye, d, 0, inf});
                        nearest_stage(world, b);
                        INFO("eye " << text(eye) << ", direction " << text(d));
                        if (t != -1) REQUIRE(b.far[0] == t);
                        t = b.far[0];
                        const Real round = hit_sphere({vec3(0), 1}, {eye, d, 0, inf});
                        if (ball_t != -1) REQUIRE(round == ball_t);
                        ball_t = round;
                    }
            }
}

TEST_CASE("22 needles up to 1e12 times as long as wide are hit between their corners, or not at all", "[extremes]") {
    Random random(22);
    std::int64_t phantoms = 0, hits = 0;
    for (int k = 0; k < 1000000; ++k) {
        const Real scale = random.scale(1e-6, 1e6), aspect = random.scale(1e6, 1e12);
        const Frame frame = frame_about(random.direction());
        const vec3 a = random.vector(0.1 * scale, 10 * scale), b = a + scale * frame.x;
        const vec3 c = a + scale * (random.number() * frame.x + frame.y / aspect);
        const vec3 target = a + random.number() * (b - a), eye = target + random.vector(scale, 1e3 * scale);
        const Ray ray{eye, unit(target - eye), 0, inf};
        const Real t = hit_triangle({a, b, c}, ray);
        if (t == inf) continue;
        ++hits;
        // The point is within the box of the corners, up to roundings of the distance that the ray came.
        const vec3 p = eye + t * ray.direction, middle = 0.5 * (a + b);
        phantoms += largest(p - middle) > 0.51 * scale + 16 * roundoff * (largest(eye) + largest(p));
    }
    CHECK(hits > 1000);
    figure(22, "phantom hits of needles, among " + std::to_string(hits), double(phantoms), 0);
}

TEST_CASE("23 a triangle without area is never hit, and changes nothing about its neighbours", "[extremes]") {
    Random random(23);
    std::int64_t hits = 0;
    for (int k = 0; k < 1000000; ++k) {
        // Corners whose sums are exact: a, a + v, a + 2v or twice the same.
        const auto whole = [&] {
            return vec3(random.integer(-1000, 1000), random.integer(-1000, 1000), random.integer(-1000, 1000));
        };
        const vec3 a = whole(), v = whole(), target = a + random.between(0, 2) * v,
                   eye = target + random.vector(1, 1e4);
        const int shape = random.integer(0, 2);
        const Triangle t{a, a + v, shape == 0 ? a + 2.0 * v : shape == 1 ? a : a + v};
        hits += hit_triangle(t, {eye, target - eye, 0, inf}) < inf;
    }
    figure(23, "hits of triangles without area, of 1000000", double(hits), 0);

    Mesh mesh = ball(2, 0.1, random);
    const World without = world_of_mesh(mesh);
    const std::size_t n = mesh.triangles.size();
    for (std::size_t i = 0; i < n; i += 3)
        mesh.triangles.push_back({mesh.triangles[i].x, mesh.triangles[i].y, mesh.triangles[i].y});
    const World with = world_of_mesh(mesh);
    Missed found;
    shoot(with, mesh, vec3(0), 1, 2000, random, found);
    CHECK(found.misses == 0);
    std::int64_t different = 0;
    for (int k = 0; k < 1000; ++k) {
        Batch one{};
        one.count = lanes;
        for (int i = 0; i < lanes; ++i) {
            const vec3 eye = random.vector(2, 10);
            one.set_ray(i, {eye, unit(random.in_cube() - eye), 0, inf});
        }
        Batch two = one;
        nearest_stage(without, one);
        nearest_stage(with, two);
        for (int i = 0; i < lanes; ++i) different += one.far[i] != two.far[i] || one.shape[i] != two.shape[i];
    }
    figure(23, "rays that meet something else beside triangles without area", double(different), 0);
}
