#include "rt/lamps/lamp_tree.h"

#include <cmath>
#include <random>

#include "catch.h"
#include "estimate.h"
#include "rt/files/scene_reader.h"
#include "rt/world.h"
#include "scenes.h"

using namespace rt;

namespace {

/// So many lamps of all kinds and brightnesses over a floor, some of them behind others, and a glossy ball.
Scene many_lamps(int count) {
    std::mt19937_64 engine(9);
    std::uniform_real_distribution<Real> share(0, 1);
    Scene scene = parse_scene(scene_table("[render]", {{"samples", 64}, {"one_lamp", true}}) +
                                  camera({0, 3, 7}, {0, 0.5, 0}, {{"size", "[24, 16]"}}) +
                                  material("grey", {{"albedo", 0.6}, {"specular", 0.2}, {"shininess", 8}}) +
                                  material("glossy", {{"reflectance", 0.9}, {"exponent", 20}}) +
                                  quad("grey", {0, 0, 0}, {6, 0, 0}, {0, 0, -6}) + sphere("glossy", {0, 0.6, 0}, 0.6),
                              "many.toml");
    for (int k = 0; k < count; ++k) {
        Material lamp;
        lamp.emission = std::exp(4 * share(engine)) * Color(1, 0.8, 0.6);
        scene.materials.push_back(lamp);
        const vec3 center(8 * share(engine) - 4, 1 + 2 * share(engine), 8 * share(engine) - 4);
        Shape shape{Sphere{center, 0.1}, int(scene.materials.size()) - 1, vec3(0)};
        if (k % 3 == 1) shape.geometry = Quad{center, {0.2, 0, 0}, {0, 0, 0.1}};
        if (k % 3 == 2) shape.geometry = Disc{center, unit(vec3(share(engine) - 0.5, -1, 0)), 0.15};
        scene.shapes.push_back(shape);
    }
    return scene;
}

}  // namespace

TEST_CASE("lamp tree: probabilities add up to 1, and lamps are chosen with them") {
    for (const int count : {1, 2, 3, 7, 64, 100}) {
        const World world = make_world(many_lamps(count));
        const LampTree tree(world.emitters);
        for (const vec3 p : {vec3(0), vec3(3, 2, 1), vec3(1e6, 0, 0), vec3(-1e-9, 1.5, 0)}) {
            Sum sum;
            for (int l = 0; l < count; ++l) sum.add(tree.probability(std::size_t(l), p));
            CAPTURE(count, p.x);
            CHECK(sum.value() == Approx(1).epsilon(1e-12));

            const int draws = 20000;
            std::vector<int> chosen(std::size_t(count), 0);
            for (int k = 0; k < draws; ++k) {
                const LampTree::Choice c = tree.choose(p, (k + 0.5) / draws);
                REQUIRE(c.lamp < std::size_t(count));
                REQUIRE(c.probability == Approx(tree.probability(c.lamp, p)).epsilon(1e-12));
                ++chosen[c.lamp];
            }
            // u runs through the lamps one after the other: each has its share, to one draw at either end
            for (int l = 0; l < count; ++l)
                CHECK(std::abs(chosen[std::size_t(l)] - draws * tree.probability(std::size_t(l), p)) <= 2);
        }
    }
}

TEST_CASE("lamp tree: the bright and near are likelier") {
    std::vector<Emitter> lamps(3);
    for (Emitter& lamp : lamps) lamp.kind = Emitter::Kind::sphere, lamp.sphere.radius = 0.1;
    lamps[0].sphere.center = {10, 0, 0}, lamps[1].sphere.center = {-10, 0, 0}, lamps[2].sphere.center = {0, 30, 0};
    lamps[1].radiance = Color(2);
    const LampTree tree(lamps);
    CHECK(tree.probability(1, vec3(0)) > tree.probability(0, vec3(0)));
    CHECK(tree.probability(0, vec3(9, 0, 0)) > 0.9);
    CHECK(tree.probability(2, vec3(0, 29, 0)) > 0.9);
}

TEST_CASE("lamp tree: at a lamp's centre, and with lamps of which one outshines all, probabilities are numbers") {
    std::vector<Emitter> lamps(5);
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        lamps[i].kind = Emitter::Kind::disc;
        lamps[i].disc = {vec3(Real(i % 3)), {0, 0, 1}, 1e-6};
        lamps[i].radiance = Color(std::pow(10.0, 100.0 * Real(i) - 200));
    }
    const LampTree tree(lamps);
    for (const vec3 p : {vec3(0), vec3(1), vec3(2), vec3(1e150), vec3(1e-300, 0, 0)})
        for (const Real u : {0., 0.5, below_one}) {
            const LampTree::Choice c = tree.choose(p, u);
            CAPTURE(p.x, u, c.lamp, c.probability);
            CHECK((c.probability > 0 && c.probability <= 1));
            CHECK(c.lamp < lamps.size());
        }
}

TEST_CASE("one lamp: the same picture with fewer shadow rays, also by solid angle and weighed against lobes") {
    Scene scene = many_lamps(24);
    for (const bool weighed : {false, true})
        for (const Sampler sampler : {Sampler::random, Sampler::orthogonal}) {
            scene.multiple_importance = scene.solid_angle = weighed;
            scene.one_lamp = false;
            const Estimate all = estimate(scene, sampler, 12);
            scene.one_lamp = true;
            const Estimate one = estimate(scene, sampler, 48);
            for (int c = 0; c < 3; ++c) {
                CAPTURE(weighed, int(sampler), c, all.mean[c], one.mean[c]);
                CHECK(std::abs(all.mean[c] - one.mean[c]) < 4.5 * std::sqrt(all.variance[c] + one.variance[c]));
            }
        }
    scene.multiple_importance = false;
    const Rendering one = render(scene, {.samples = 16, .estimate_error = false});
    CHECK(one.rays[int(RayKind::shadow)] <= 2 * one.rays[int(RayKind::camera)]);
}

TEST_CASE("one lamp: where there is one alone everything stays as it is") {
    Scene scene = many_lamps(1);
    CHECK(!make_plan(scene).one_lamp);
    const Image with = render(scene, {.samples = 4, .estimate_error = false}).image;
    scene.one_lamp = false;
    CHECK(render(scene, {.samples = 4, .estimate_error = false}).image.pixels == with.pixels);
}
