#include <cmath>

#include "catch.h"
#include "rt/files/scene_reader.h"
#include "rt/media/regions.h"
#include "rt/render.h"
#include "rt/world.h"
#include "scenes.h"

/// Paths that start inside of media, and shadow rays that go through their boundaries.

using namespace rt;

namespace {

struct Means {
    Real mean, least, most;
    std::size_t below;  // pixels that lack a hundredth
};

Means means_of(const Scene& scene, int samples) {
    const Image image = render(scene, {.samples = samples, .sampler = scene.sampler}).image;
    Means m{0, inf, -inf, 0};
    for (const Color& c : image.pixels) {
        m.mean += c.x / Real(image.pixels.size());
        m.least = std::min(m.least, c.x), m.most = std::max(m.most, c.x);
        m.below += c.x < 0.99;
    }
    return m;
}

Means means_of(const Scene& scene) { return means_of(scene, scene.samples); }

Means means_of(const std::string& text) { return means_of(parse_scene(text, "scenes/inside_media_test.toml")); }

/// A scene with fog of an extinction of 0.5, and a lamp of radiance 1 before the eye, 4 m away.
std::string lamp_in_fog(vec3 eye, const std::string& shapes, const grade::SceneKeys& lens = {}) {
    grade::SceneKeys view = {{"vfov", 1}, {"size", "[4, 4]"}};
    view.insert(view.end(), lens.begin(), lens.end());
    return scene_table("[render]", {{"samples", 4096}}) + camera(eye, {0, 0, 0}, view) +
           material("lamp", {{"emission", 1}}) +
           material("fog", {{"transmittance", 1}, {"medium", "{ extinction = 0.5, albedo = 0 }"}}) +
           material("clear", {{"transmittance", 1}}) +
           material("thick", {{"transmittance", 1}, {"medium", "{ extinction = 1, albedo = 0 }"}}) +
           material("glass", {{"reflectance", 1}, {"transmittance", 1}, {"ior", 1.5}}) +
           quad("lamp", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}) + shapes;
}

std::string ball(vec3 center, double radius, const std::string& of = "fog") { return sphere(of, center, radius); }

/// The six walls of a box about the origin, their fronts outside.
std::string box(double half, const std::string& of) {
    std::string walls;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {half, -half}) {
            vec3 center(0), u(0), v(0);
            center[axis] = side, u[(axis + 1) % 3] = half, v[(axis + 2) % 3] = side;
            walls += quad(of, center, u, v);
        }
    return walls;
}

constexpr Real through = 0.01;  // what 65,536 paths of one picture leave uncertain, five standard errors

}  // namespace

TEST_CASE("each of the scenes that were drawn wrongly has its value", "[inside]") {
    const auto mean = [](const char* name) {
        return means_of(read_scene(std::string("tests/cases/scenes/") + name + ".toml"));
    };
    CHECK(std::abs(mean("camera_in_fog").mean - std::exp(-2.0)) < 0.003);
    CHECK(std::abs(mean("point_light_in_fog").mean / 0.03946 - 1) < 0.01);
    CHECK(mean("inside_sphere_lamp").most == 0);
    CHECK(std::abs(mean("tiny_absorbing_ball").mean - std::exp(-0.8)) < 0.02);
    const Means mirror = mean("smooth_icosahedron_mirror");
    CHECK(mirror.below == 0);
    CHECK(std::abs(mirror.mean - 1) < 1e-12);
}

TEST_CASE("an eye in fog sees through as much of it as there is before it, whatever encloses it", "[inside]") {
    const vec3 at(0, 0, 4);
    const auto sees = [&](const std::string& text) { return means_of(text).mean; };
    const Real e = std::exp(1.0);
    // 4 m of it
    for (const std::string& fog : {ball({0, 0, 0}, 10), ball({3, 2, 1}, 20), box(6, "fog"), ball({0, 0, 4}, 5),
                                   ball({0, 0, 0}, 10) + ball({0, 0, 1}, 7), ball({0, 0, 0}, 10) + box(5, "fog")}) {
        INFO(fog);
        CHECK(std::abs(sees(lamp_in_fog(at, fog)) - std::pow(e, -2)) < through);
    }
    // a clear ball of 2 m before the eye, or around it, in the fog; one of thicker fog; a ball with another one in it
    const std::string fog = ball({0, 0, 0}, 10);
    CHECK(std::abs(sees(lamp_in_fog(at, fog + ball({0, 0, 2}, 1, "clear"))) - std::pow(e, -1)) < through);
    CHECK(std::abs(sees(lamp_in_fog(at, ball({0, 0, 4}, 1, "clear") + fog)) - std::pow(e, -1.5)) < through);
    CHECK(std::abs(sees(lamp_in_fog(at, fog + ball({0, 0, 2}, 1, "thick"))) - std::pow(e, -3)) < through);
    CHECK(std::abs(sees(lamp_in_fog(at, fog + ball({0, 0, 2}, 1, "thick") + ball({0, 0, 2}, 0.5, "clear"))) -
                   std::pow(e, -2)) < through);
    CHECK(std::abs(sees(lamp_in_fog(at, fog + box(2, "clear"))) - std::pow(e, -1)) < through);
    // two that overlap: the smaller one is what is there
    CHECK(std::abs(sees(lamp_in_fog(at, ball({0, 0, 4}, 2.5) + ball({0, 0, 1}, 1.5, "thick"))) -
                   std::pow(e, -0.75 - 2.5)) < through);
    // outside of it, and with more of it behind the eye
    CHECK(std::abs(sees(lamp_in_fog(at, ball({0, 0, 8}, 3))) - 1) < 1e-12);
    CHECK(std::abs(sees(lamp_in_fog(at, ball({0, 0, 2}, 1))) - std::pow(e, -1)) < through);
}

TEST_CASE("an eye on a boundary is on the side to which it looks", "[inside]") {
    const Real e = std::exp(1.0);
    const auto sees = [](const std::string& text) { return means_of(text).mean; };
    CHECK(std::abs(sees(lamp_in_fog({0, 0, 4}, ball({0, 0, 0}, 4))) - std::pow(e, -2)) < through);
    CHECK(std::abs(sees(lamp_in_fog({0, 0, 4}, box(4, "fog"))) - std::pow(e, -2)) < through);
    CHECK(std::abs(sees(lamp_in_fog({0, 0, 4}, ball({0, 0, 8}, 4))) - 1) < 1e-12);
    // at a place where no number is round
    CHECK(std::abs(sees(lamp_in_fog({0.7, 1.1, 3.9}, ball({0, 0, 0}, std::sqrt(0.49 + 1.21 + 15.21)))) -
                   std::exp(-0.5 * std::sqrt(0.49 + 1.21 + 15.21))) < through);
    // glass: Fresnel's law is not asked, for the eye is in it
    CHECK(means_of(lamp_in_fog({0, 0, 4}, ball({0, 0, 0}, 4, "glass"))).least == 1);
}

TEST_CASE("a lens that a boundary cuts, and a boundary in motion: each ray knows where it starts", "[inside]") {
    // Half of the lens is in the fog of a box whose wall goes through the eye: 4 m of it or none.
    const Real cut =
        means_of(lamp_in_fog({0, 0, 4}, ball({1000, 0, 0}, 1000), {{"lens_radius", 0.01}, {"focus", 4}})).mean;
    CHECK(std::abs(cut - 0.5 * (1 + std::exp(-2.0))) < 0.1);  // the wall bends, and the rays come together
    // A ball that has the eye in it for half of the time.
    const std::string moving = sphere("fog", {0, 0, 4}, 2, {0, 4, 0}) + grade::shutter(0, 1);
    const Real moved = means_of(lamp_in_fog({0, 0, 4}, moving)).mean;
    Real expected = 0;
    for (int i = 0; i < 1000; ++i) {
        const Real up = 4 * (i + 0.5) / 1000;
        expected += (up < 2 ? std::exp(-0.5 * std::sqrt(4 - up * up)) : 1) / 1000;
    }
    CHECK(std::abs(moved - expected) < through);
}

TEST_CASE("lights outside of fog reach what is in it, dimmed by their way through", "[inside]") {
    const auto floor_lit_by = [](const std::string& light, const std::string& fog, int bounces = 0) {
        const bool sky = light == "environment";
        return means_of(environment(sky ? 1 : 0) + scene_table("[render]", {{"samples", 1024}, {"bounces", bounces}}) +
                        camera({0, 2, 0.001}, {0, 0, 0}, {{"vfov", 0.5}, {"size", "[8, 8]"}}) +
                        material("white", {{"albedo", 0.5}}) + material("lamp", {{"emission", 100}}) +
                        material("fog", {{"transmittance", 1}, {"medium", "{ extinction = 0.3, albedo = 0 }"}}) +
                        material("tint", {{"transmittance", 0.5}}) +
                        quad("white", {0, 0, 0}, {0.5, 0, 0}, {0, 0, -0.5}) + (sky ? "" : light) + fog)
            .mean;
    };
    const std::string point = point_light({0, 5, 0}, 10), sun = grade::directional_light({0, 1, 0}, 10),
                      lamp = disc("lamp", {0, 5, 0}, {0, -1, 0}, 0.1);
    // The way of the light through the fog, and that to the camera, in means free paths.
    const auto dims = [&](const std::string& light, const std::string& fog, Real depth) {
        const Real clear = floor_lit_by(light, ""), dim = floor_lit_by(light, fog);
        CAPTURE(light, fog, dim / clear, std::exp(-depth));
        CHECK(std::abs(dim / clear / std::exp(-depth) - 1) < 0.03);
    };
    for (const std::string& light : {point, sun, lamp}) {
        dims(light, ball({0, 0, 0}, 3), 0.3 * (3 + 2));
        dims(light, ball({0, 0, 0}, 1), 0.3 * (1 + 1));
        dims(light, ball({0, 3.5, 0}, 1), 0.3 * 2);  // between the two alone
        dims(light, ball({0, 0, 0}, 3, "tint"), std::log(2.0));
    }
    dims(point, ball({0, 0, 0}, 10), 0.3 * (5 + 2));
    dims(point, ball({0, 0, 0}, 5), 0.3 * (5 + 2));  // the light on the boundary
    dims("environment", ball({0, 0, 0}, 1), 0.3 * (1 + 1));
    // Rays that bounce find the lamp and the sky as well, and must not count them once more.
    for (const std::string& light : {lamp, std::string("environment")})
        CHECK(std::abs(floor_lit_by(light, ball({0, 0, 0}, 1), 3) / floor_lit_by(light, ball({0, 0, 0}, 1), 0) - 1) <
              0.02);
}

TEST_CASE("which regions a point is in: spheres, boxes, closed meshes; not behind a single pane", "[inside]") {
    const auto start = [](vec3 eye, const std::string& shapes) {
        const World world = make_world(parse_scene(lamp_in_fog(eye, shapes), "scenes/inside_media_test.toml"));
        const Index material = world.regions.medium(world.regions.start);
        return material < 0 ? std::string() : name_of_material(world.scene, material);
    };
    const std::string mesh = "[[shape]]\ntype = \"mesh\"\nfile = \"icosahedron.obj\"\nmaterial = \"fog\"\nscale = 3\n";
    CHECK(start({0, 0, 2}, mesh) == "fog");
    CHECK(start({0, 0, 3.5}, mesh) == "");
    CHECK(start({0, 0, 2}, mesh + ball({0, 0, 2}, 0.5, "thick")) == "thick");
    CHECK(start({0, 0, 2}, mesh + ball({0, 0, 2}, 0.5, "clear")) == "");
    CHECK(start({0, 0, 2}, ball({0, 0, 0}, 9, "thick") + mesh) == "fog");
    CHECK(start({0, 0, 4}, ball({0, 0, 0}, 9, "thick") + mesh) == "thick");
    CHECK(start({0, 0, 2}, box(3, "fog")) == "fog");
    CHECK(start({0, 0, 4}, box(3, "fog")) == "");
    CHECK(start({0, 0, 2}, quad("fog", {0, 0, 5}, {50, 0, 0}, {0, 50, 0})) == "");
}

TEST_CASE("regions side by side in one number: entered and left in any order", "[inside]") {
    for (const int bits : {1, 2, 4, 7, 16, 21, 33}) {
        const Bits most = bits == 1 ? 1 : 3;
        Bits in = 0;
        for (Bits r = 1; r <= most; ++r) in = entered(in, r, bits);
        CHECK(innermost(in, bits) == most);
        CHECK(entered(in, most, bits) == in);
        CHECK(innermost(left(in, most, bits), bits) == (most == 1 ? 0 : bits == 33 ? 0 : 2));
        for (Bits r = 1; r <= most; ++r) in = left(in, r, bits);
        CHECK(in == 0);
    }
    // sixteen of four bits are all that fit
    Bits in = 0;
    for (Bits r = 15; r >= 1; --r) in = entered(in, r, 4);
    CHECK(innermost(in, 4) == 15);
    CHECK(left(in, 15, 4) == in >> 4);
}

TEST_CASE("mirrors and glass with interpolated normals lose no light", "[inside]") {
    for (const char* material :
         {"reflectance = 1", "reflectance = 1\ntransmittance = 1\nior = 1.5",
          "reflectance = 1\ntransmittance = 1\nior = 2.4", "reflectance = 1\ntransmittance = 1\nior = 0.7"}) {
        INFO(material);
        const Means m = means_of(
            "environment = 1\n[render]\nsamples = 64\ndepth = 1000\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n"
            "vfov = 30\nsize = [64, 64]\n[materials.m]\n" +
            std::string(material) +
            "\n[[shape]]\ntype = \"mesh\"\nfile = \"icosahedron.obj\"\nmaterial = \"m\"\nsmooth = true\n");
        CHECK(m.below == 0);
        CHECK(std::abs(m.mean - 1) < 1e-9);
    }
}

TEST_CASE("radiance that no picture can hold is refused", "[inside]") {
    const std::string camera = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n";
    const auto complaint = [](const std::string& text) { return complaint_of([&] { parse_scene(text, "s.toml"); }); };
    CHECK(complaint("environment = 1e39\n" + camera)
              .starts_with("s.toml:1:15: 'environment' is 1e+39; expected a number from 0 to 3.4e38"));
    CHECK(complaint("background = 1e39\n" + camera).starts_with("s.toml:1:14: 'background' is 1e+39"));
    CHECK(
        complaint(camera + "[materials.m]\nemission = [0, 1e39, 0]\n").starts_with("s.toml:5:16: 'emission' is 1e+39"));
    CHECK(complaint("environment = 3.4e38\n" + camera) == "");
}
