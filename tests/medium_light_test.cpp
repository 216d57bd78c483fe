#include <numeric>

#include "catch.h"

#include "estimate.h"
#include "rt/files/scene_reader.h"
#include "rt/render.h"
#include "scenes.h"

namespace {

/// A floor in fog that swallows all that it meets, under a small ball that shines; one pixel looks at the point below
/// it.
const std::string fog = scene_table("[render]", {{"samples", 262144}}) +
                        camera({3, 0, 4}, {0, 0, 0}, {{"vfov", 0.001}, {"size", "[1, 1]"}}) +
                        material("fog", {{"transmittance", 1}, {"medium", "{ extinction = 0.7, albedo = 0 }"}}) +
                        material("floor", {{"albedo", 0.5}}) + material("lamp", {{"emission", 10}}) +
                        sphere("fog", {0, 0, 0}, 3) + disc("floor", {0, 0, 0}, {0, 0, 1}, 1) +
                        sphere("lamp", {0, 0, 1}, 0.2);

/// A ball of milk before the eye.
std::string milk(const char* medium, const std::string& others) {
    return "environment = 0.1\n" + scene_table("[render]", {{"samples", 64}, {"depth", 64}}) +
           camera({0, 0, 4}, {0, 0, 0}, {{"vfov", 26}, {"size", "[8, 8]"}}) +
           material("milk", {{"transmittance", vec3(1, 0.9, 0.8)}, {"medium", medium}}) +
           material("clear", {{"transmittance", 1}}) + material("glass", {{"transmittance", 1}, {"ior", 1.5}}) +
           material("wall", {{"albedo", 0.5}}) + material("lamp", {{"emission", vec3(40, 30, 20)}}) +
           sphere("milk", {0, 0, 0}, 1) + others;
}

constexpr const char* white = "{ extinction = 3, albedo = [0.98, 0.9, 0.8] }";
constexpr const char* forward = "{ extinction = 3, albedo = 0.95, g = 0.7 }";

/// Two pictures of one mean: no channel is apart by what 1 of 100,000 pairs is.
void agree(const rt::Estimate& a, const rt::Estimate& b) {
    for (int c = 0; c < 3; ++c) {
        const double error = std::sqrt(a.variance[c] + b.variance[c]);
        CAPTURE(c, a.mean[c], b.mean[c], error);
        CHECK(std::abs(a.mean[c] - b.mean[c]) < 5.3 * error);  // Student's t of 46 degrees of freedom
    }
}

std::uint64_t all(const rt::RayCounts& rays) { return std::accumulate(rays.begin(), rays.end(), std::uint64_t(0)); }

rt::Rendering drawn(const rt::Scene& scene) {
    return rt::render(scene, {.samples = 16, .sampler = scene.sampler, .estimate_error = false});
}

}  // namespace

TEST_CASE("a medium dims the light that shadow rays gather inside it") {
    // Irradiance: L exp(-s t) cos over the cone of the ball, t the distance to its near side.
    const double s = 0.7, radius = 0.2;
    double irradiance = 0;
    const int n = 10000;
    const double low = std::sqrt(1 - radius * radius);  // cosine of the cone
    for (int i = 0; i < n; ++i) {
        const double c = low + (1 - low) * (i + 0.5) / n;
        const double t = c - std::sqrt(radius * radius - (1 - c * c));
        irradiance += 2 * rt::pi * (1 - low) / n * 10 * std::exp(-s * t) * c;
    }
    // The way to the camera: 3 m of fog, which a path survives with this probability.
    const double expected = irradiance * 0.5 / rt::pi * std::exp(-s * 3);

    const rt::Scene scene = rt::parse_scene(fog, "fog.toml");
    const rt::Rendering r = rt::render(scene, {.samples = scene.samples, .sampler = rt::Sampler::random});
    const double value = r.image.at(0, 0).x, share = std::exp(-s * 3);
    // Standard error: of the share of paths that survive, in the main.
    const double error = expected * std::sqrt((1 - share) / share / scene.samples);
    CAPTURE(value, expected, error);
    CHECK(std::abs(value - expected) < 4 * error);
}

TEST_CASE("lamps where media scatter: the same picture with less noise, wherever the lamp is") {
    struct Case {
        const char* where;
        std::string text;
        bool solid_angle = false, one_lamp = false;
    };
    const std::string far = disc("lamp", {0, 2, 0}, {0, -1, 0}, 0.2),
                      wall = quad("wall", {0, -1, 0}, {3, 0, 0}, {0, 0, -3});
    const std::string facing = quad("lamp", {0, 0.3, 0}, {0.1, 0, 0}, {0, 0, 0.1});  // down
    const Case cases[] = {
        {"outside", milk(white, far)},
        {"outside, forward", milk(forward, far)},
        {"outside, and a wall that cuts the ball", milk(white, far + wall)},
        {"a ball in a clear hollow", milk(white, sphere("clear", {0, 0, 0}, 0.3) + sphere("lamp", {0, 0, 0}, 0.1))},
        {"a quad in the milk", milk(white, facing)},
        {"a quad in the milk, by solid angle", milk(white, facing), true},
        {"behind glass", milk(white, sphere("glass", {0, 1.8, 0}, 0.5) + sphere("lamp", {0, 1.8, 0}, 0.2))},
        {"one of two", milk(white, far + disc("lamp", {0, -2, 0}, {0, 1, 0}, 0.3)), false, true},
    };
    for (const Case& c : cases) {
        CAPTURE(c.where);
        rt::Scene scene = rt::parse_scene(c.text, "milk.toml");
        scene.solid_angle = c.solid_angle, scene.one_lamp = c.one_lamp, scene.media_lit = false;
        const rt::Estimate alone = rt::estimate(scene, rt::Sampler::random, 24);
        scene.media_lit = true;
        const rt::Estimate lit = rt::estimate(scene, rt::Sampler::random, 24);
        agree(alone, lit);
        if (std::string(c.where) != "behind glass") CHECK(lit.noise < 0.5 * alone.noise);
    }
}

TEST_CASE("lamps where media scatter: shadow rays alone find them where a path may not cross the boundary any more") {
    // the way into the ball takes the only crossing of depth 1; a path that leaves it finds nothing but the lamp
    rt::Scene scene = rt::parse_scene(milk(white, disc("lamp", {0, 2, 0}, {0, -1, 0}, 0.8)), "milk.toml");
    scene.environment = rt::Color(0), scene.media_lit = true;
    const rt::Estimate deep = rt::estimate(scene, rt::Sampler::random, 24);
    scene.depth = 1;
    agree(deep, rt::estimate(scene, rt::Sampler::random, 24));
}

TEST_CASE("lamps where media scatter: no shadow ray where none can arrive, and no other number is drawn") {
    const auto same = [](const std::string& text) {
        rt::Scene scene = rt::parse_scene(text, "milk.toml");
        scene.media_lit = false;
        const rt::Rendering alone = drawn(scene);
        scene.media_lit = true;
        const rt::Rendering asked = drawn(scene);
        CHECK(asked.rays[int(rt::RayKind::shadow)] == alone.rays[int(rt::RayKind::shadow)]);
        return asked.image.pixels == alone.image.pixels && asked.rays == alone.rays;
    };
    const std::string lamp = disc("lamp", {0, 2, 0}, {0, -1, 0}, 0.2),
                      floor = quad("wall", {0, -1, 0}, {3, 0, 0}, {0, 0, -3});
    CHECK(same(milk(white, floor)));
    CHECK(same(milk("{ extinction = 3, albedo = 0 }", lamp + floor)));
    std::string bent = milk(white, lamp + floor);
    const std::string straight = "[materials.milk]\n";
    bent.insert(bent.find(straight) + straight.size(), "ior = 1.4\n");
    CHECK(same(bent));
    CHECK(!rt::make_plan(rt::parse_scene(bent, "milk.toml")).media_lit);
    CHECK(rt::make_plan(rt::parse_scene(milk(white, lamp), "milk.toml")).media_lit);
    // as bright as all around: nothing stands out
    const std::string even = milk(white, quad("lamp", {0, 2, 0}, {9, 0, 0}, {0, 0, 9}));
    CHECK(
        !rt::make_plan(rt::parse_scene("environment = [40, 30, 20]\n" + even.substr(even.find('\n') + 1), "milk.toml"))
             .media_lit);
}

TEST_CASE("roulette: the same mean, and less noise for as many rays where paths are long") {
    const std::string lamp = disc("lamp", {0, 2, 0}, {0, -1, 0}, 1);
    const std::string smoke = milk("{ extinction = 20, albedo = [0.8, 0.6, 0.3] }", lamp);
    const std::string rooms = "environment = 0\n" + scene_table("[render]", {{"samples", 64}, {"bounces", 30}}) +
                              camera({0, 0, 0}, {0, 0, -1}, {{"vfov", 60}, {"size", "[8, 8]"}}) +
                              material("wall", {{"albedo", vec3(0.5, 0.4, 0.3)}}) +
                              material("lamp", {{"emission", 5}, {"albedo", 0.5}}) + sphere("wall", {0, 0, 0}, 2) +
                              sphere("lamp", {0, 1, 0}, 0.5);
    for (const std::string& text : {smoke, rooms}) {
        rt::Scene scene = rt::parse_scene(text, "smoke.toml");
        CHECK(rt::make_plan(scene).roulette);
        scene.roulette = false;
        const rt::Estimate whole = rt::estimate(scene, rt::Sampler::random, 24);
        const rt::RayCounts rays = drawn(scene).rays;
        scene.roulette = true;
        const rt::Estimate ended = rt::estimate(scene, rt::Sampler::random, 24);
        const rt::RayCounts fewer = drawn(scene).rays;
        agree(whole, ended);
        CAPTURE(whole.noise, ended.noise, all(rays), all(fewer));
        CHECK(ended.noise * rt::Real(all(fewer)) < 0.8 * whole.noise * rt::Real(all(rays)));
    }
}

TEST_CASE("roulette: off where paths are short or lose little, and no other number is drawn where there is none") {
    const auto on = [](const std::string& text) { return rt::make_plan(rt::parse_scene(text, "s.toml")).roulette; };
    CHECK(!on(milk(white, "")));
    CHECK(!on(milk("{ extinction = 20, albedo = [0.99, 0.6, 0.3] }", "")));
    CHECK(!on(milk("{ extinction = 20, albedo = 0 }", "")));
    CHECK(on(milk("{ extinction = 20, albedo = [0.8, 0.6, 0.3] }", "")));
    rt::Scene scene = rt::read_scene("scenes/penumbra.toml");
    const rt::Rendering without = drawn(scene);
    scene.roulette = true;
    CHECK(!rt::make_plan(scene).roulette);
    const rt::Rendering asked = drawn(scene);
    CHECK((without.image.pixels == asked.image.pixels && without.rays == asked.rays));
}
