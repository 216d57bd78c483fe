/// The tree against brute force, and degenerate scenes: extremes.md 10, 26, 28, 31.

#include "extremes/meshes.h"
#include "rt/stages/stages.h"

using namespace rt;

namespace {

/// Spheres, triangles, quads and discs in a unit cube, in clumps: neighbours touch and overlap.
Scene crowd(int n, Random& random) {
    Scene scene = plain_scene();
    const Real size = std::cbrt(1.0 / n);
    vec3 clump(0);
    for (int i = 0; i < n; ++i) {
        if (i % 16 == 0) clump = random.in_cube();
        const vec3 c = clump + 4 * size * random.in_cube();
        const Frame frame = frame_about(random.direction());
        Shape shape;
        switch (i % 4) {
            case 0:
                shape.geometry = Sphere{c, size * random.scale(0.01, 1)};
                break;
            case 1:
                shape.geometry = Triangle{c, c + size * random.in_cube(), c + size * random.in_cube()};
                break;
            case 2:
                shape.geometry = Quad{c, size * frame.x, size * random.scale(0.01, 1) * frame.y};
                break;
            case 3:
                shape.geometry = Disc{c, frame.z, size * random.scale(0.01, 1)};
                break;
        }
        scene.shapes.push_back(shape);
    }
    return scene;
}

/// The same rays through the tree and one shape after the other.
std::int64_t differences(World& world, const Batch& rays) {
    Batch b = rays, one_by_one = rays;
    nearest_stage(world, b);
    world.plan.bvh = false;
    nearest_stage(world, one_by_one);
    world.plan.bvh = true;
    std::int64_t different = 0;
    for (int i = 0; i < b.count; ++i) different += b.far[i] != one_by_one.far[i] || b.shape[i] != one_by_one.shape[i];
    return different;
}

Batch rays_through(Random& random, Real scale = 1) {
    Batch b{};
    b.count = lanes;
    for (int i = 0; i < lanes; ++i) {
        const vec3 target = scale * random.in_cube(),
                   eye = i % 2 ? scale * random.in_cube() : random.vector(2 * scale, 1e3 * scale);
        b.set_ray(i, {eye, unit(target - eye), 0, inf});
    }
    return b;
}

/// Rays side by side, all of which may have a part of their direction that is 0, or so small that it might as well be.
Batch beam_through(Random& random, Real width, bool flat) {
    const vec3 target = random.in_cube(), eye = random.integer(0, 1) ? random.in_cube() : random.vector(2, 1e3);
    const Real tiny[] = {0.0, -0.0, 1e-300, -1e-300, 1e-30, -1e-12};
    Batch b{};
    b.count = lanes - random.integer(0, 5);
    const int axis = random.integer(0, 2);
    for (int i = 0; i < b.count; ++i) {
        vec3 d = unit(target - eye + width * random.in_cube());
        if (flat) d[axis] = tiny[random.integer(0, 5)];
        b.set_ray(i, {eye + 0.1 * width * random.in_cube(), d, 0, random.integer(0, 7) ? inf : random.number()});
    }
    return b;
}

}  // namespace

TEST_CASE("10 likewise for rays that run side by side", "[extremes]") {
    Random random(102);
    std::int64_t different = 0, rays = 0, hits = 0, occluded = 0;
    const std::int64_t wanted = count_of(4e5, 4e6);
    for (int round = 0; round < 16; ++round) {
        World world = make_world(crowd(round % 4 ? 400 : 4000, random));
        REQUIRE(world.plan.bvh);
        for (std::int64_t k = 0; k < wanted / 16 / lanes + 1; ++k) {
            const Batch b = beam_through(random, random.scale(1e-4, 0.5), k % 3 == 0);
            different += differences(world, b), rays += b.count;
            Batch nearest = b, any = b;
            nearest_stage(world, nearest), any_hit_stage(world, any);
            for (int i = 0; i < b.count; ++i) {
                hits += nearest.shape[i] != nothing;
                occluded += (nearest.shape[i] == nothing) != (any.shape[i] == nothing);
            }
        }
    }
    CHECK(hits > rays / 50);
    figure(10, "rays side by side that the tree answers in another way, of " + std::to_string(rays), double(different),
           0);
    figure(10, "of these, rays that meet something in one stage alone", double(occluded), 0);
}

TEST_CASE("10 the tree finds what brute force finds, bit by bit", "[extremes]") {
    Random random(10);
    std::int64_t different = 0, rays = 0;
    const std::int64_t wanted = count_of(1e6, 1e7);
    for (int round = 0; round < 16; ++round) {
        World world = make_world(crowd(round % 2 ? 120 : 400, random));
        REQUIRE(world.plan.bvh);
        for (std::int64_t k = 0; k < wanted / 16 / lanes + 1; ++k)
            different += differences(world, rays_through(random)), rays += lanes;
    }
    figure(10, "rays that the tree answers in another way, of " + std::to_string(rays), double(different), 0);
}

TEST_CASE("10 likewise where rays go through edges and corners that shapes share, ties by number", "[extremes]") {
    Random random(101);
    std::int64_t different = 0, rays = 0;
    for (const ClosedMesh& closed : closed_meshes()) {
        Scene scene = plain_scene();
        scene.meshes.push_back(closed.mesh);
        scene.meshes.push_back(closed.mesh);  // everything twice
        const std::size_t n = closed.mesh.triangles.size();
        World world = make_world(scene);
        if (!world.plan.bvh) continue;
        const int batches = int(count_of(2e7, 2e8) / double(n) / lanes) + 1;
        for (int k = 0; k < batches; ++k) {
            Batch b{};
            b.count = lanes;
            for (int i = 0; i < lanes; ++i) {
                const auto t = closed.mesh.triangles[std::size_t(random.integer(0, int(n) - 1))];
                const vec3 p = closed.mesh.vertices[std::size_t(t.x)], q = closed.mesh.vertices[std::size_t(t.y)];
                const vec3 target = i % 3 ? p + random.number() * (q - p) : p, eye = random.vector(0.1, 1e4);
                b.set_ray(i, {eye, unit(target - eye), 0, inf});
            }
            different += differences(world, b), rays += lanes;
        }
    }
    figure(10, "rays at edges and corners that the tree answers in another way, of " + std::to_string(rays),
           double(different), 0);
}

TEST_CASE("26 origins on the faces of boxes, directions with zeros of either sign", "[extremes]") {
    Random random(26);
    Scene scene = plain_scene();
    // A grid of cubes' faces: boxes that are flat and touch each other.
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z) {
                const vec3 c(x, y, z);
                scene.shapes.push_back({Quad{c, {0.5, 0, 0}, {0, 0.5, 0}}, 0, vec3(0)});
                scene.shapes.push_back({Quad{c, {0, 0.5, 0}, {0, 0, 0.5}}, 0, vec3(0)});
            }
    World world = make_world(scene);
    std::int64_t different = 0;
    const Real parts[] = {0.0, -0.0, 1, -1, 1e-300, -1e-300, 0.5};
    for (int k = 0; k < 2000; ++k) {
        Batch b{};
        b.count = lanes;
        for (int i = 0; i < lanes; ++i) {
            const auto half = [&] { return random.integer(-6, 6) * 0.5; };
            const auto part = [&] { return parts[random.integer(0, 6)]; };
            vec3 d{part(), part(), part()};
            if (d == vec3(0)) d.x = 1;
            b.set_ray(i, {{half(), half(), half()}, d, 0, inf});
        }
        different += differences(world, b);
    }
    figure(26, "rays in the faces of boxes that the tree answers in another way, of 128000", double(different), 0);
}

TEST_CASE("28 1e5 identical triangles: the tree is built, and the lowest number wins", "[extremes]") {
    Scene scene = plain_scene();
    scene.shapes.push_back({Triangle{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, 0, vec3(0)});
    for (int i = 0; i < 100000; ++i) scene.shapes.push_back({Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, 0, vec3(0)});
    const World world = make_world(scene);
    Random random(28);
    Batch b{};
    b.count = 16;
    for (int i = 0; i < b.count; ++i)
        b.set_ray(i, {{0.1 * random.number(), 0, 3}, {0.01, 0.01 * random.number(), -1}, 0, inf});
    nearest_stage(world, b);
    for (int i = 0; i < b.count; ++i) CHECK(b.shape[i] == 1);
}

TEST_CASE("31 1e5 and 1e6 shapes, as brute force", "[extremes]") {
    Random random(31);
    for (const int n : {100000, 1000000}) {
        World world = make_world(crowd(n, random));
        const int batches = int(count_of(n == 100000 ? 2e3 : 256, 1e4) / lanes) + 1;
        std::int64_t different = 0;
        for (int k = 0; k < batches; ++k) different += differences(world, rays_through(random));
        figure(31, std::to_string(n) + " shapes: rays answered in another way, of " + std::to_string(batches * lanes),
               double(different), 0);
    }
}
