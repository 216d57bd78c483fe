#include "rt/files/scene_reader.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include "catch.h"
#include "rt/files/obj_reader.h"

namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

const fs::path here = fs::path(__FILE__).parent_path();

/// What each scene in bad_scenes/ must be told.
const std::map<std::string, std::string> complaints = {
    {"albedo_above_one.toml", "albedo_above_one.toml:6:10: 'albedo' is 1.01; expected "},
    {"bad_mesh.toml", "bad_face.obj:4:7: a face has vertex 4; expected "},
    {"beyond_double.toml", "beyond_double.toml:16:15: '1e400' could not be interpreted as a value; expected "},
    {"beyond_range.toml", "beyond_range.toml:15:14: 'center' is 1e+300; expected "},
    {"checker_without_size.toml", "checker_without_size.toml:7:11: 'size' is missing"},
    {"checker_zero.toml", "checker_zero.toml:7:46: 'size' is 0; expected "},
    {"deep_key.toml", "deep_key.toml:6:130: too many dots in one key; expected "},
    {"doubled_key.toml", "doubled_key.toml:17:10: cannot redefine existing integer 'radius'; expected "},
    {"empty.toml", "empty.toml:1:1: the file is empty; expected "},
    {"eye_is_target.toml", "eye_is_target.toml:3:10: the camera's target is its eye; expected "},
    {"flat_quad.toml", "flat_quad.toml:17:5: 'v' is zero; expected "},
    {"flat_triangle.toml", "flat_triangle.toml:15:5: the triangle has no area; expected "},
    {"focus_zero.toml", "focus_zero.toml:4:9: 'focus' is 0; expected "},
    {"inf.toml", "inf.toml:15:14: 'center' is inf; expected "},
    {"light_table.toml", "light_table.toml:8:1: 'light' is a table; expected "},
    {"medium_g.toml", "medium_g.toml:6:32: 'g' is 1; expected "},
    {"medium_without_extinction.toml", "medium_without_extinction.toml:7:10: 'extinction' is missing"},
    {"minus_zero_radius.toml", "minus_zero_radius.toml:16:10: 'radius' is -0; expected "},
    {"missing_key.toml", "missing_key.toml:13:1: 'radius' is missing in [[shape]]; expected "},
    {"missing_material.toml", "missing_material.toml:17:12: there is no material 'whit'; expected "},
    {"missing_mesh.toml", "missing_mesh.toml:15:8: 'nowhere.obj' cannot be read: No such file or directory; expected "},
    {"nan.toml", "nan.toml:16:10: 'radius' is nan; expected "},
    {"negative_light.toml", "negative_light.toml:11:17: 'intensity' is -1; expected "},
    {"negative_radius.toml", "negative_radius.toml:16:10: 'radius' is -1; expected "},
    {"no_camera.toml", "no_camera.toml:1:1: there is no camera; expected "},
    {"no_material.toml", "no_material.toml:13:1: 'material' is missing in [[shape]]; expected "},
    {"no_samples.toml", "no_samples.toml:2:11: 'samples' is 0; expected "},
    {"not_utf8.toml", "not_utf8.toml:5:15: Encountered invalid utf-8 sequence; expected "},
    {"only_a_comment.toml", "only_a_comment.toml:1:1: there is no camera; expected "},
    {"sampled_triangle.toml", "sampled_triangle.toml:18:12: shadow rays cannot look for"},
    {"shutter_closes_first.toml", "shutter_closes_first.toml:7:9: the shutter closes before it opens; expected "},
    {"size_fraction.toml", "size_fraction.toml:4:9: 'size' is a number; expected "},
    {"size_too_large.toml", "size_too_large.toml:4:8: 'size' has more than 268435456 pixels; expected "},
    {"size_zero.toml", "size_zero.toml:4:9: 'size' is 0; expected "},
    {"skewed_quad.toml", "skewed_quad.toml:17:5: 'u' and 'v' meet at a cosine of 0.0995; expected "},
    {"syntax.toml", "syntax.toml:6:10: could not determine value type; expected "},
    {"unknown_key.toml", "unknown_key.toml:3:1: unknown key 'targt' in [camera]; expected "},
    {"unknown_sampler.toml", "unknown_sampler.toml:2:11: 'sampler' is 'halton'; expected "},
    {"unknown_shape.toml", "unknown_shape.toml:14:8: 'type' is 'spere'; expected "},
    {"unknown_table.toml", "unknown_table.toml:8:3: unknown key 'lights' in the file; expected "},
    {"up_along_sight.toml", "up_along_sight.toml:3:10: the camera looks along 'up'; expected "},
    {"vfov_half_turn.toml", "vfov_half_turn.toml:4:8: 'vfov' is 180; expected "},
    {"vfov_zero.toml", "vfov_zero.toml:4:8: 'vfov' is 0; expected "},
    {"wrong_length.toml", "wrong_length.toml:2:7: 'eye' has 2 numbers; expected "},
    {"wrong_type.toml", "wrong_type.toml:2:7: 'eye' is a string; expected "},
    {"zero_direction.toml", "zero_direction.toml:10:10: 'toward' is zero; expected "},
    {"zero_normal.toml", "zero_normal.toml:16:10: 'normal' is zero; expected "},
    {"zero_radius.toml", "zero_radius.toml:16:10: 'radius' is 0; expected "},
    {"zero_scale.toml", "zero_scale.toml:16:13: 'scale' is 0; expected "},
    {"zero_up.toml", "zero_up.toml:4:6: 'up' is zero; expected "},
};

const std::string small_scene = R"(title = "everything once"
ambient = 0.25
environment = [0.1, 0.2, 0.3]
background = [0.4, 0.5, 0.6]

[render]
samples = 7
bounces = 2
depth = 3
sampler = "stratified"
exposure = 0.5

[camera]
eye = [0, 0, 5]
target = [0, 0, 1]
up = [0, 2, 0]
vfov = 90
size = [30, 20]
lens_radius = 0.125
focus = inf

[shutter]
open = -1
close = 2.5

[materials.all]
ambient = 0.1
albedo = [0.2, 0.3, 0.4]
specular = 0.5
shininess = 20
reflectance = 0.6
transmittance = 0.7
exponent = 50
ior = 1.5
emission = 8
sampled = false
checker = { albedo = [0, 0.5, 1], size = 0.25 }
medium = { extinction = 3, albedo = [0.9, 0.8, 0.7], g = -0.5 }

[[light]]
type = "point"
position = [1, 2, 3]
intensity = [4, 5, 6]

[[light]]
type = "directional"
toward = [0, 10, 0]
irradiance = 2

[[shape]]
type = "sphere"
center = [1, 2, 3]
radius = 0.5
material = "all"
velocity = [1, 0, -1]

[[shape]]
type = "triangle"
a = [0, 0, 0]
b = [1, 0, 0]
c = [0, 1, 0]
material = "all"

[[shape]]
type = "quad"
center = [0, 1, 0]
u = [2, 0, 0]
v = [0, 0, -3]
material = "all"

[[shape]]
type = "disc"
center = [0, 3, 0]
normal = [0, -4, 0]
radius = 2
material = "all"
)";

/// The message of the InputError that the text earns; empty: it is a scene.
std::string complaint(const std::string& text) {
    try {
        rt::parse_scene(text, "s.toml");
        return "";
    } catch (const rt::InputError& error) {
        return error.what();
    }
}

bool is_located(const std::string& message) {
    int line = 0, column = 0, text = 0;
    return std::sscanf(message.c_str(), "s.toml:%d:%d: %n", &line, &column, &text) == 2 && line > 0 && column > 0 &&
           text > 0 && message.find("; expected ") != std::string::npos && message.find('\n') == std::string::npos;
}

/// Start and length of the value in each line that has one.
std::vector<std::pair<std::size_t, std::size_t>> values(const std::string& text) {
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (auto i = text.find(" = "); i != std::string::npos; i = text.find(" = ", text.find('\n', i)))
        found.emplace_back(i + 3, text.find('\n', i) - i - 3);
    return found;
}

fs::path temporary_file(const std::string& name, const std::string& text) {
    const auto path = fs::temp_directory_path() / ("penumbra_reader_test_" + name);
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

std::string obj_complaint(const std::string& text) {
    const auto path = temporary_file("bad.obj", text);
    try {
        rt::read_obj(path.string(), false);
        return "";
    } catch (const rt::InputError& error) {
        return std::string(error.what()).substr(path.string().size());
    }
}

}  // namespace

TEST_CASE("each bad scene is told what is wrong, and where", "[reader]") {
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(here / "bad_scenes")) {
        if (entry.path().extension() != ".toml") continue;
        ++files;
        const auto name = entry.path().filename().string();
        INFO(name);
        REQUIRE(complaints.count(name) == 1);
        std::string message = "no complaint";
        try {
            rt::read_scene(entry.path().string());
        } catch (const rt::InputError& error) {
            message = error.what();
        }
        const auto folder = (here / "bad_scenes").string() + "/";
        REQUIRE(message.substr(0, folder.size()) == folder);
        const auto& expected = complaints.at(name);
        CHECK(message.substr(folder.size(), expected.size()) == expected);
    }
    CHECK(files == complaints.size());
}

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

TEST_CASE("any value may be replaced by any other: the answer is a scene or a located error", "[reader]") {
    const std::string others[] = {"nan",
                                  "-nan",
                                  "inf",
                                  "-inf",
                                  "1e400",
                                  "-1e400",
                                  "1e308",
                                  "1e-400",
                                  "4.9e-324",
                                  "-0.0",
                                  "0",
                                  "-1",
                                  "0x10",
                                  "true",
                                  "[]",
                                  "{}",
                                  "[[1]]",
                                  "[nan, 0, 0]",
                                  "[0, 0, 0]",
                                  "[1, 2, 3]",
                                  "[1, 2]",
                                  "''",
                                  "",
                                  "\"\"",
                                  "[[]]",
                                  "[{}]",
                                  "{ x = 1 }",
                                  "1979-05-27",
                                  "99999999999999999999"};
    for (const auto& [start, length] : values(small_scene))
        for (const std::string& other : others) {
            const std::string text = std::string(small_scene).replace(start, length, other);
            const std::string message = complaint(text);
            INFO("'" << small_scene.substr(start, length) << "' becomes '" << other << "': " << message);
            CHECK((message.empty() || is_located(message)));
        }
}

TEST_CASE("a number that is not finite never gets into a scene", "[reader]") {
    const std::string with_inf = "focus exponent";
    for (const auto& [start, length] : values(small_scene))
        for (const std::string other : {"nan", "inf", "1e400", "[nan, 1, 1]", "[1, -inf, 1]"}) {
            const auto line = small_scene.rfind('\n', start) + 1;
            const std::string key = small_scene.substr(line, small_scene.find(' ', line) - line);
            if (other == "inf" && with_inf.find(key) != std::string::npos) continue;
            INFO(key << " = " << other);
            CHECK(complaint(std::string(small_scene).replace(start, length, other)) != "");
        }
}

TEST_CASE("no sequence of bytes crashes the reader", "[reader]") {
    std::mt19937 random(1);
    const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
    const std::string bytes = "\0\n\t\"'#=.,[]{}-+_e0919anif\xff\xc3(\xef\xbb\xbf\x7f\r\\u"s;
    for (int round = 0; round < 4000; ++round) {
        std::string text = small_scene;
        for (auto edits = 1 + below(6); edits > 0; --edits) {
            const auto place = below(text.size());
            if (below(3) == 0)
                text.erase(place, 1 + below(20));
            else if (below(2) == 0)
                text.insert(place, 1, bytes[below(bytes.size())]);
            else
                text[place] = bytes[below(bytes.size())];
            if (text.empty()) text = "x";
        }
        const std::string message = complaint(text);
        INFO("round " << round << ": " << message);
        REQUIRE((message.empty() || is_located(message)));
    }
}

TEST_CASE("deep nesting of any kind is an error", "[reader]") {
    const auto repeat = [](const std::string& piece, int n) {
        std::string text;
        for (int i = 0; i < n; ++i) text += piece;
        return text;
    };
    for (const std::string& text :
         {repeat("a.", 100000) + "a = 1", "[" + repeat("a.", 100000) + "a]", repeat("a . ", 100000) + "a = 1",
          repeat("'a'.", 100000) + "a = 1", "a = " + repeat("[", 100000), "a = " + repeat("{a=", 100000),
          "a = {" + repeat("a.", 100000) + "a = 1}"})
        CHECK(is_located(complaint(text)));
}

TEST_CASE("faces of an OBJ file become triangles", "[reader]") {
    const std::string vertices = "# a square\r\nv 0 0 0\r\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    const auto path = temporary_file("quad.obj", vertices + "f 1 2 3 4\nf -4/1/1 -3// -2\n");
    const auto flat = [&] { return rt::read_obj(path.string(), false); };
    CHECK_THROWS_AS(flat(), rt::InputError);  // the last face names a normal that is not there

    temporary_file("quad.obj", vertices + "f 1 2 3 4\nf -4 -3 -2");
    const rt::Mesh mesh = flat();
    REQUIRE(mesh.triangles.size() == 3);
    CHECK(mesh.triangles[0] == glm::ivec3(0, 1, 2));
    CHECK(mesh.triangles[1] == glm::ivec3(0, 2, 3));
    CHECK(mesh.triangles[2] == glm::ivec3(0, 1, 2));
    CHECK(mesh.normals.empty());

    const rt::Mesh smooth = rt::read_obj(path.string(), true);
    REQUIRE(smooth.normals.size() == smooth.vertices.size());
    for (const auto& n : smooth.normals) CHECK(n == rt::vec3(0, 0, 1));
}

TEST_CASE("a mesh keeps the normals of its file, and turns them with a mirror image", "[reader]") {
    temporary_file("tilted.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 1\nf 1//1 2//1 3//1\n");
    const auto path = temporary_file("tilted.toml", R"([camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[materials.m]
[[shape]]
type = "mesh"
file = "penumbra_reader_test_tilted.obj"
smooth = true
scale = [-1, 1, 1]
translate = [0, 0, 1]
material = "m"
)");
    const rt::Mesh mesh = rt::read_scene(path.string()).meshes.at(0);
    const auto at = [&](int i) { return mesh.vertices[std::size_t(mesh.triangles[0][i])]; };
    CHECK(rt::cross(at(1) - at(0), at(2) - at(0)) == rt::vec3(0, 0, 1));
    CHECK(mesh.normals[0].x == Approx(-std::sqrt(0.5)));
    CHECK(mesh.normals[0].z == Approx(std::sqrt(0.5)));
    CHECK(at(0) == rt::vec3(0, 0, 1));
}

TEST_CASE("what is wrong in an OBJ file is told with its line", "[reader]") {
    CHECK(obj_complaint("v 0 0 x\n").rfind(":1:7: ", 0) == 0);
    CHECK(obj_complaint("v 0 0 0\nv 0 nan 0\n").rfind(":2:5: ", 0) == 0);
    CHECK(obj_complaint("v 0 0 0\nv 0 1e400 0\n").rfind(":2:5: ", 0) == 0);
    CHECK(obj_complaint("v 0 0 0\nv 1 0\n").rfind(":2:1: ", 0) == 0);
    CHECK(obj_complaint("v 0 0 0\n\n\nf 1 1\n").rfind(":4:1: ", 0) == 0);
    CHECK(obj_complaint("v 0 0 0\nf 1 1 0\n").rfind(":2:7: ", 0) == 0);
    CHECK(obj_complaint("v 0 0 0\nf 1 1 1 -2\n").rfind(":2:9: ", 0) == 0);
    CHECK(obj_complaint("v 0 0 0\nf 1 1 99999999999\n").rfind(":2:7: ", 0) == 0);
    CHECK(obj_complaint("") != "");
    CHECK(obj_complaint("\x7f"
                        "ELF\x01\xff\n\xfe") != "");
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
