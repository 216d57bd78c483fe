#include "rt/files/scene_reader.h"

#include <filesystem>

#include "catch.h"
#include "small_scene.h"

namespace {

namespace fs = std::filesystem;

const fs::path here = fs::path(__FILE__).parent_path();

}  // namespace

TEST_CASE("a file that is not there, or is a folder, is an input error", "[reader]") {
    CHECK_THROWS_AS(rt::read_scene((here / "no_such_scene.toml").string()), rt::InputError);
    CHECK_THROWS_AS(rt::read_scene(here.string()), rt::InputError);
}

TEST_CASE("every key of a scene arrives", "[reader]") {
    const rt::Scene s = rt::parse_scene(small_scene, "s.toml");
    CHECK(s.path == "s.toml");
    CHECK((s.samples == 7 && s.bounces == 2 && s.depth == 3 && s.exposure == 0.5));
    CHECK(s.sampler == rt::Sampler::stratified);
    CHECK(s.ambient == rt::Color(0.25));
    CHECK(s.environment == rt::Color(0.1, 0.2, 0.3));
    CHECK(s.background == rt::Color(0.4, 0.5, 0.6));

    const rt::Camera& c = s.camera;
    CHECK((c.eye == rt::vec3(0, 0, 5) && c.back == rt::vec3(0, 0, 1)));
    CHECK((c.right == rt::vec3(1, 0, 0) && c.up == rt::vec3(0, 1, 0)));
    CHECK(c.tan_half_fov == Approx(1));
    CHECK((c.size == rt::ivec2(30, 20) && c.lens_radius == 0.125 && c.focus == rt::inf));
    CHECK((s.shutter.open == -1 && s.shutter.close == 2.5));

    REQUIRE(s.materials.size() == 1);
    const rt::Material& m = s.materials[0];
    CHECK(s.material_names == std::vector<std::string>{"all"});
    CHECK((m.ambient == rt::Color(0.1) && m.albedo == rt::Color(0.2, 0.3, 0.4) && m.specular == rt::Color(0.5)));
    REQUIRE(m.checker);
    CHECK((m.checker->albedo == rt::Color(0, 0.5, 1) && m.checker->size == 0.25));
    CHECK((m.shininess == 20 && m.exponent == 50 && m.ior == 1.5 && !m.sampled));
    CHECK((m.reflectance == rt::Color(0.6) && m.transmittance == rt::Color(0.7) && m.emission == rt::Color(8)));
    CHECK((m.medium.extinction == 3 && m.medium.albedo == rt::Color(0.9, 0.8, 0.7) && m.medium.g == -0.5));

    REQUIRE(s.lights.size() == 2);
    CHECK((s.lights[0].position == rt::vec3(1, 2, 3) && s.lights[0].intensity == rt::Color(4, 5, 6)));
    CHECK((s.lights[1].directional && s.lights[1].position == rt::vec3(0, 1, 0)));

    REQUIRE(s.shapes.size() == 4);
    CHECK(std::get<rt::Sphere>(s.shapes[0].geometry).radius == 0.5);
    CHECK(s.shapes[0].velocity == rt::vec3(1, 0, -1));
    CHECK(std::get<rt::Triangle>(s.shapes[1].geometry).c == rt::vec3(0, 1, 0));
    CHECK(std::get<rt::Quad>(s.shapes[2].geometry).v == rt::vec3(0, 0, -3));
    CHECK(std::get<rt::Disc>(s.shapes[3].geometry).normal == rt::vec3(0, -1, 0));
}

TEST_CASE("the default focus is the distance of the target", "[reader]") {
    const auto s = rt::parse_scene("[camera]\neye = [0, 3, 4]\ntarget = [0, 0, 0]\n", "s.toml");
    CHECK(s.camera.focus == 5);
    CHECK(s.camera.size == rt::ivec2(256, 256));
}

TEST_CASE("every scene of the project is a scene", "[reader]") {
    int scenes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(here.parent_path() / "scenes"))
        if (entry.path().extension() == ".toml") {
            INFO(entry.path());
            CHECK_NOTHROW(rt::read_scene(entry.path().string()));
            ++scenes;
        }
    CHECK(scenes > 0);
}
