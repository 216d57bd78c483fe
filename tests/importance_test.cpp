#include "rt/lamps/importance.h"

#include <cmath>

#include "catch.h"
#include "estimate.h"
#include "rt/files/scene_reader.h"
#include "rt/fragments.h"
#include "rt/sampler.h"
#include "scenes.h"

using namespace rt;

namespace {

/// Three lobes under lamps of each kind; one of the balls is rough glass.
const std::string lamps_and_lobes =
    environment(0.1) + scene_table("[render]", {{"samples", 64}, {"bounces", 1}}) +
    camera({0, 3, 7}, {0, 0.5, 0}, {{"size", "[24, 16]"}}) + material("grey", {{"albedo", 0.5}}) +
    material("lamp", {{"emission", 9}}) + material("broad", {{"reflectance", vec3(0.4, 0.7, 0.9)}, {"exponent", 4}}) +
    material("narrow", {{"reflectance", 0.8}, {"exponent", 300}, {"albedo", 0.1}}) +
    material("rough", {{"transmittance", 0.9}, {"reflectance", 0.9}, {"exponent", 40}, {"ior", 1.5}}) +
    quad("grey", {0, 0, 0}, {9, 0, 0}, {0, 0, -9}) + quad("lamp", {2, 4, 1}, {0.5, 0, 0}, {0, 0, 0.5}) +
    disc("lamp", {-2, 4, 1}, {0, -1, 0}, 0.5) + sphere("lamp", {0, 3, -2}, 0.4) + sphere("broad", {-2, 0.9, 0}, 0.9) +
    sphere("narrow", {0, 0.9, 0}, 0.9) + sphere("rough", {2, 0.9, 0}, 0.9);

vec2 numbers(int i) { return sobol_2d(11, std::uint32_t(i), 4); }

}  // namespace

TEST_CASE("the density of a lobe is that of phong_lobe, and is 1 in all") {
    const vec3 n = unit(vec3(0.2, 0.5, 0.8)), d = unit(vec3(0.4, -0.7, -0.3));
    for (const Real exponent : {0., 1., 6., 100., 1e5}) {
        const Frame about = frame_about(mirror_direction(d, n));
        for (int i = 0; i < 1000; ++i) {
            const DirectionSample sample = phong_lobe(exponent, numbers(i));
            CAPTURE(exponent, i);
            CHECK(lobe_density(exponent, about.to_world(sample.direction), n, -d) ==
                  Approx(sample.density).epsilon(1e-9 * (1 + exponent)).margin(1e-12));
        }
        // Over the sphere, with the cosine to the mirror direction as c = 1 - 2 s^2: rings near the peak are narrow.
        Real sum = 0;
        const int rings = 20000;
        for (int k = 0; k < rings; ++k) {
            const Real s = (k + 0.5) / rings, c = 1 - 2 * s * s;
            const vec3 l = about.to_world({2 * s * std::sqrt(1 - s * s), 0, c});
            sum += 2 * pi * 4 * s / rings * lobe_density(exponent, l, n, -d);
        }
        CHECK(sum == Approx(1).epsilon(1e-3));
    }
}

TEST_CASE("the density of a lamp is that of light_sample") {
    const World world = make_world(parse_scene(lamps_and_lobes, "lamps.toml"));
    REQUIRE(world.emitters.size() == 3);
    const vec3 p{0.3, 0.2, -0.1};
    for (const Emitter& emitter : world.emitters) {
        const auto found = std::find_if(world.surfaces.begin(), world.surfaces.end(), [&](const SurfaceRecord& r) {
            return r.emitter != nothing && r.center == center(emitter);
        });
        REQUIRE(found != world.surfaces.end());
        const Index lamp = found - world.surfaces.begin();
        for (int i = 0; i < 200; ++i) {
            const LightSample sample = light_sample(emitter, p, numbers(i));
            CAPTURE(int(emitter.kind), i);
            CHECK(light_density(world, world.surfaces[std::size_t(lamp)], {p, sample.direction, 0, inf},
                                sample.distance) == Approx(sample.density));
        }
    }
}

TEST_CASE("the weights of both techniques add up to 1, also at the ends") {
    for (const Real p : {1e-300, 1e-3, 1., 1e5, 1e300})
        for (const Real q : {1e-300, 1e-3, 1., 1e5, 1e300}) {
            CAPTURE(p, q);
            CHECK(power_heuristic(p, q) + power_heuristic(q, p) == Approx(1));
        }
    CHECK(power_heuristic(0, 1) == 0);
    CHECK(power_heuristic(1, 0) == 1);
    CHECK(power_heuristic(0, 0) == 0);
}

TEST_CASE("multiple importance sampling changes the noise, not the picture") {
    Scene scene = parse_scene(lamps_and_lobes, "lamps.toml");
    for (const Sampler sampler : {Sampler::random, Sampler::orthogonal}) {
        scene.multiple_importance = false;
        const Estimate lobes = estimate(scene, sampler, 40);
        scene.multiple_importance = true;
        const Estimate both = estimate(scene, sampler, 40);
        for (int c = 0; c < 3; ++c) {
            CAPTURE(int(sampler), c, lobes.mean[c], both.mean[c]);
            CHECK(std::abs(lobes.mean[c] - both.mean[c]) < 4.5 * std::sqrt(lobes.variance[c] + both.variance[c]));
        }
    }
    // Most of the noise is that of the rough glass, which is not weighed.
    scene.shapes.pop_back();
    scene.multiple_importance = false;
    const Real lobes = estimate(scene, Sampler::orthogonal, 10).noise;
    scene.multiple_importance = true;
    const Real both = estimate(scene, Sampler::orthogonal, 10).noise;
    CAPTURE(lobes, both);
    CHECK(both < 0.6 * lobes);
}

TEST_CASE("without lobes or lamps multiple importance sampling leaves everything as it is") {
    const auto picture = [](Scene scene, bool both) {
        scene.multiple_importance = both;
        return render(scene, {.samples = 4, .estimate_error = false});
    };
    Scene smooth = parse_scene(lamps_and_lobes, "lamps.toml"), dark = smooth;
    for (Material& m : smooth.materials) m.exponent = inf;
    for (Material& m : dark.materials) m.sampled = false;
    for (const Scene& scene : {smooth, dark}) {
        const Rendering with = picture(scene, true), without = picture(scene, false);
        CHECK(with.image.pixels == without.image.pixels);
        CHECK(with.rays == without.rays);
    }
}

TEST_CASE("what bounces brings the environment's light as shadow rays do, at less cost") {
    const std::string text =
        environment(vec3(1, 0.7, 0.4)) + scene_table("[render]", {{"samples", 64}, {"bounces", 2}}) +
        camera({0, 3, 7}, {0, 0.5, 0}, {{"size", "[24, 16]"}}) + material("grey", {{"albedo", 0.6}}) +
        material("shiny", {{"reflectance", 0.8}}) + material("both", {{"albedo", 0.5}, {"reflectance", 0.1}}) +
        quad("grey", {0, 0, 0}, {9, 0, 0}, {0, 0, -9}) + sphere("grey", {-1, 0.9, 0}, 0.9) +
        sphere("shiny", {1, 0.9, 0}, 0.9);
    const Scene by_bounces = parse_scene(text, "scene.toml"),
                // one speck that is a mirror and diffuse, so that surfaces may go on by chance
        by_shadow_rays = parse_scene(text + sphere("both", {0, 1000, 0}, 1e-3), "scene.toml");
    CHECK(make_plan(by_bounces).sky_by_bounces);
    CHECK_FALSE(make_plan(by_shadow_rays).sky_by_bounces);
    const Estimate bounced = estimate(by_bounces, Sampler::random, 40),
                   looked_for = estimate(by_shadow_rays, Sampler::random, 40);
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c, bounced.mean[c], looked_for.mean[c]);
        CHECK(std::abs(bounced.mean[c] - looked_for.mean[c]) <
              4.5 * std::sqrt(bounced.variance[c] + looked_for.variance[c]));
    }
    CHECK(bounced.noise < looked_for.noise);
    const auto rays = [](const Scene& scene) {
        return render(scene, {.samples = 4}).rays[std::size_t(RayKind::shadow)];
    };
    CHECK(2 * rays(by_bounces) < rays(by_shadow_rays));
}
