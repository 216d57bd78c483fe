/// Lights of any strength, files with anything in them: extremes.md 16, 41, 63 to 66, 68.

#include <filesystem>

#include "exr.h"
#include "extremes/transform.h"
#include "rt/fragments.h"

using namespace rt;

namespace {

const std::string head = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n[materials.m]\nalbedo = 0.5\nemission = 1\n";

/// The message that a scene with these lines, from the seventh on, earns; empty: none.
std::string complaint(const std::string& lines) {
    return complaint_of([&] { parse_scene(head + lines, "s.toml"); });
}

}  // namespace

TEST_CASE("16 66 shapes and lights without size, singular transforms: rejected by name, with line and column",
          "[extremes]") {
    const std::pair<const char*, const char*> cases[] = {
        {"[[shape]]\ntype = 'sphere'\ncenter = [0, 0, 0]\nradius = 0\nmaterial = 'm'", "s.toml:10:10: 'radius' is 0"},
        {"[[shape]]\ntype = 'sphere'\ncenter = [0, 0, 0]\nradius = -0.0\nmaterial = 'm'",
         "s.toml:10:10: 'radius' is -0"},
        {"[[shape]]\ntype = 'disc'\ncenter = [0, 0, 0]\nnormal = [0, 0, 0]\nradius = 1\nmaterial = 'm'",
         "s.toml:10:10: 'normal' is zero"},
        {"[[shape]]\ntype = 'disc'\ncenter = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 0\nmaterial = 'm'",
         "s.toml:11:10: 'radius' is 0"},
        {"[[shape]]\ntype = 'quad'\ncenter = [0, 0, 0]\nu = [0, 0, 0]\nv = [0, 1, 0]\nmaterial = 'm'",
         "s.toml:10:5: 'u' is zero"},
        {"[[shape]]\ntype = 'quad'\ncenter = [0, 0, 0]\nu = [1, 0, 0]\nv = [0, 0, 0]\nmaterial = 'm'",
         "s.toml:11:5: 'v' is zero"},
        {"[materials.dark]\n[[shape]]\ntype = 'mesh'\nfile = 'x.obj'\nscale = [1, 0, 1]\nmaterial = 'dark'",
         "s.toml:11:13: 'scale' is 0"},
        {"[[light]]\ntype = 'directional'\ntoward = [0, 0, 0]\nirradiance = 1", "s.toml:9:10: 'toward' is zero"},
        {"[[light]]\ntype = 'point'\nposition = [0, 0, 0]\nintensity = -1", "s.toml:10:13: 'intensity' is -1"},
        {"[[light]]\ntype = 'point'\nposition = [0, 0, nan]\nintensity = 1", "s.toml:9:19: 'position' is nan"},
        {"[[light]]\ntype = 'point'\nposition = [0, 0, 1e400]\nintensity = 1", "s.toml:9:"},
        {"[[light]]\ntype = 'point'\nposition = [0, 0, 0]\nposition = [0, 0, 1]\nintensity = 1", "s.toml:10:"},
        {"[[light]]\ntype = 'point'\nintensity = 1", "s.toml:7:1: 'position' is missing"},
    };
    for (const auto& [lines, expected] : cases) {
        const std::string message = complaint(lines);
        INFO(lines << "\n" << message);
        CHECK(message.rfind(expected, 0) == 0);
        CHECK(message.find("; expected ") != std::string::npos);
    }
}

TEST_CASE("65 -0, denormals, the largest and smallest numbers: a scene or a located error, and a picture without a NaN",
          "[extremes]") {
    const char* numbers[] = {"-0.0", "4.9e-324", "1e-308", "1e-200", "1e-70", "1e-30", "1e30", "1e70", "1e71", "1e308"};
    int pictures = 0;
    for (const char* a : numbers)
        for (const char* b : {"1e-300", "1e-70", "1e-30", "1.0", "1e30", "1e70"})
            for (const std::string shape : {"type = 'sphere'\nradius = $b\ncenter = [$a, 0, 0]\n",
                                            "type = 'disc'\nradius = $b\nnormal = [0, $a, 1]\ncenter = [0, 0, $a]\n",
                                            "type = 'quad'\nu = [$b, 0, 0]\nv = [0, $b, 0]\ncenter = [0, $a, 0]\n"}) {
                std::string text =
                    head +
                    "[[light]]\ntype = 'point'\nposition = [$b, $a, 1]\nintensity = $b\n[[shape]]\nmaterial = 'm'\n" +
                    shape;
                for (const auto& [name, number] : {std::pair<std::string, std::string>{"$a", a}, {"$b", b}})
                    for (auto at = text.find(name); at != std::string::npos; at = text.find(name))
                        text.replace(at, 2, number);
                INFO(text);
                try {
                    Scene scene = parse_scene(text, "s.toml");
                    scene.camera.size = {4, 4};
                    scene.samples = 2;
                    picture(scene);
                    ++pictures;
                } catch (const InputError& error) {
                    const std::string what = error.what();
                    CHECK(what.rfind("s.toml:", 0) == 0);
                }
            }
    CHECK(pictures > 50);
}

TEST_CASE("41 63 intensities and emissions of 0, 1e-30 and 1e30: finite, zero is never drawn, all add up",
          "[extremes]") {
    for (const std::string name : {"penumbra", "sphere_light", "disc_light", "whitted", "color_bleeding"})
        for (const Real power : {1e-30, 1e30}) {
            const Scene scene = small_scene(name);
            const Image image = picture(scene), strong = picture(brighter(scene, power));
            for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                REQUIRE(std::isfinite(strong.pixels[i].x + strong.pixels[i].y + strong.pixels[i].z));
                REQUIRE(largest(strong.pixels[i] / power - image.pixels[i]) <= 1e-13 * largest(image.pixels[i]));
            }
        }

    // A lamp of power 0 is no lamp: no ray, no random number.
    Scene scene = small_scene("penumbra");
    const Image without = picture(scene);
    Material dark = scene.materials[0];
    dark.emission = dark.albedo = Color(0);
    scene.materials.push_back(dark);
    scene.shapes.push_back({Quad{{0, 1e5, 0}, {1, 0, 0}, {0, 0, 1}}, int(scene.materials.size()) - 1, vec3(0)});
    CHECK(make_world(scene).emitters.size() == 1);
    figure(41, "pixels that a lamp of power 0 changes", double(pixels_apart(picture(scene), without)), 0);
}

TEST_CASE("64 65504, 65520, 1e30 and 1e-30 survive the file", "[extremes]") {
    const auto path = (std::filesystem::temp_directory_path() / "penumbra_extremes_test.exr").string();
    Image image(5, 1);
    const Real values[] = {65504, 65520, 1e30, 1e-30, 1e300};
    for (int i = 0; i < 5; ++i) image.at(i, 0) = Color(values[i]);
    write_exr(path, image);
    const Image read = read_exr(path);
    for (int i = 0; i < 4; ++i) CHECK(read.at(i, 0).x == float(values[i]));
    CHECK(std::isfinite(read.at(4, 0).x));  // the greatest float
    std::filesystem::remove(path);
}

TEST_CASE("68 a point light of intensity E D^2 at D = 1e3 to 1e12: as the directional one, to 4 rho/D", "[extremes]") {
    Random random(68);
    Greatest worst;
    for (int k = 0; k < 100000; ++k) {
        const Real distance = random.scale(1e3, 1e12), rho = 1;
        const vec3 way = random.direction(), n = random.direction_about(way, 0.5),
                   p = rho * random.number() * random.direction();
        const Real near = point_irradiance({distance * way, Color(3 * distance * distance), false}, p, n).x;
        const Real far = point_irradiance({way, Color(3), true}, p, n).x;
        worst.see(std::abs(near / far - 1) / (4 * rho / distance + 16 * roundoff));
    }
    figure(68, "far point light against a directional one, relative, in 4 rho/D + 16u", worst.value, 1);
}
