/// Quads, discs and sheets: extremes.md 19, 25, 27, 29.

#include "extremes/extremes.h"
#include "rt/fragments.h"
#include "rt/stages/stages.h"

using namespace rt;

TEST_CASE("19 a quad seen at its diagonal has no hole, nor has one of two triangles", "[extremes]") {
    Random random(19);
    std::int64_t holes = 0, holes_of_two = 0;
    for (int k = 0; k < 1000000; ++k) {
        const Real scale = power_of_two(random.integer(-40, 40));
        const Frame frame = frame_about(random.direction());
        const Quad q{scale * random.in_cube(), scale * frame.x, scale * random.between(0.01, 1) * frame.y};
        const Real s = random.between(-0.999, 0.999);
        const vec3 target = q.center + s * (q.u + q.v), eye = target + random.vector(0.01 * scale, 1e3 * scale);
        const Ray ray{eye, target - eye, 0, inf};
        if (std::abs(dot(unit(ray.direction), frame.z)) < 1e-6) continue;
        holes += hit_quad(q, ray) == inf;
        const vec3 a = q.center - q.u - q.v, b = q.center + q.u - q.v, c = q.center + q.u + q.v,
                   d = q.center - q.u + q.v;
        holes_of_two += hit_triangle({a, b, c}, ray) == inf && hit_triangle({a, c, d}, ray) == inf;
    }
    figure(19, "holes at the diagonal of a quad, of 1000000", double(holes), 0);
    figure(19, "holes at the diagonal of two triangles, of 1000000", double(holes_of_two), 0);
}

TEST_CASE("25 planes seen edge-on, n.d = +-1e-12, +-1e-300, 0: a hit on the plane or none, never a NaN", "[extremes]") {
    Random random(25);
    Scene discs = plain_scene();
    discs.shapes.push_back({Disc{vec3(0), {0, 0, 1}, 1}, 0, vec3(0)});
    const World world = make_world(discs);
    for (const Real slope : {1e-12, -1e-12, 1e-300, -1e-300, 0.0, -0.0, 4.9e-324})
        for (const Real height : {0.0, -0.0, 1e-300, 1e-12, 1e-6, -1e-12, 1.0, -1.0, 1e12})
            for (int k = 0; k < 100; ++k) {
                const vec2 around = unit_circle(random.number());
                const Ray ray{{-2 * around.x, -2 * around.y, height}, {around.x, around.y, slope}, 0, inf};
                Batch b{};
                b.count = 1;
                b.set_ray(0, ray);
                nearest_stage(world, b);
                const Triangle triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
                INFO("slope " << slope << ", height " << height << ", towards " << text(around));
                for (const Real t : {hit_quad(Quad{}, ray), hit_triangle(triangle, ray), b.far[0]}) {
                    CHECK((t == inf || (t > 0 && t < 5)));
                    if (t == inf) continue;
                    CHECK(std::abs(height + t * slope) <= 8 * roundoff * (1 + std::abs(height)) + 1e-300);
                }
            }
}

TEST_CASE("27 rays at r(1 +- 10^-k) of a disc's rim: the right verdict beyond 8ud", "[extremes]") {
    Random random(27);
    Greatest wrong;
    for (int round = 0; round < 20000; ++round) {
        const Disc disc{random.vector(0.1, 10), random.direction(), random.scale(0.01, 100)};
        Scene scene = plain_scene();
        scene.shapes.push_back({disc, 0, vec3(0)});
        const World world = make_world(scene);
        const Frame frame = frame_about(disc.normal);
        Batch b{};
        b.count = 30;
        for (int i = 0; i < 30; ++i) {
            const vec2 around = unit_circle(random.number());
            const Real share = 1 + (i % 2 ? 1 : -1) * std::pow(10.0, -(i / 2 + 1));
            const vec3 rim = disc.center + share * disc.radius * (around.x * frame.x + around.y * frame.y);
            const vec3 eye = rim + disc.radius * random.scale(0.1, 1e6) * random.direction_about(disc.normal, 0.3);
            b.set_ray(i, {eye, unit(rim - eye), 0, inf});
        }
        nearest_stage(world, b);
        for (int i = 0; i < 30; ++i) {
            const Ray ray = b.ray(i);
            const Long n(disc.normal), o = Long(ray.origin) - Long(disc.center), d(ray.direction);
            const Long p = o - exact_dot(o, n) / exact_dot(d, n) * d;
            const long double outside = exact_length(p) - disc.radius;
            if ((b.shape[i] == 0) == (outside < 0)) continue;
            wrong.see(
                double(std::abs(outside) / (roundoff * (exact_length(o) / std::abs(exact_dot(d, n)) + disc.radius))));
        }
    }
    figure(27, "farthest from a disc's rim with the wrong verdict, in u(d / cos + r)", wrong.value, 8);
}

TEST_CASE("29 parallel sheets 16u z apart: the nearer one", "[extremes]") {
    Random random(29);
    std::int64_t farther = 0, farther_triangles = 0;
    for (int k = 0; k < 200000; ++k) {
        // The eye at the origin, the sheets at the distance z; each turned some way.
        const vec3 n = random.direction();
        const Frame frame = frame_about(n);
        const Real z = random.scale(1e-6, 1e6), behind = z * (1 + 16 * roundoff);
        const vec3 d = random.direction_about(n, 0.3);
        const Ray ray{vec3(0), d, 0, inf};
        const Real size = 4 * z;
        const auto quad = [&](Real at) { return hit_quad({at * n, size * frame.x, size * frame.y}, ray); };
        farther += !(quad(z) < quad(behind));

        // Corners must not be moved by more than that when they are rounded: along an axis they are not.
        const auto triangle = [&](Real at) {
            return hit_triangle({{9 * z, 0, at}, {-6 * z, 9 * z, at}, {-6 * z, -9 * z, at}}, ray);
        };
        const Real up = d.z > 0 ? 1 : -1;
        if (std::abs(d.z) > 0.5) farther_triangles += !(triangle(up * z) < triangle(up * behind));
    }
    figure(29, "quads 16u z apart, the farther one nearer, of 200000", double(farther), 0);
    figure(29, "triangles likewise", double(farther_triangles), 0);
}
