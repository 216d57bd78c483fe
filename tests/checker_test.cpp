#include <fmt/format.h>

#include <cmath>

#include "catch.h"
#include "rt/files/scene_reader.h"
#include "rt/render.h"

/// Two albedos in squares.

using namespace rt;

namespace {

constexpr int side = 96;
constexpr Real square = 0.31;

/// Shapes of the material "tiles" under light from the camera, 10 m before the origin. A pixel is its albedo, where it
/// faces the light.
Image picture(const std::string& shapes, const std::string& more = "") {
    const Scene scene = parse_scene(
        "[render]\nsamples = 1\n[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nvfov = 20\n"
        "size = [96, 96]\n" +
            more +
            "[materials.tiles]\nalbedo = [0.25, 0.5, 0]\n"
            "checker = { albedo = [0, 0.75, 1], size = 0.31 }\n"
            "[[light]]\ntype = \"directional\"\ntoward = [0, 0, 1]\nirradiance = " +
            std::to_string(pi) + "\n" + shapes,
        "scene.toml");
    return render(scene, {.samples = 1}).image;
}

/// Where the ray through a pixel is in the plane z = 0.
vec2 seen(int x, int y) {
    return 2 * 10 * std::tan(10 * pi / 180) / side * vec2(x + 0.5 - side / 2, side / 2 - y - 0.5);
}

/// Red and blue tell the albedos apart, in any shade: 1 for the second, -1 for nothing.
int shade(const Color& c) { return c == Color(0) ? -1 : c.x > 0 ? 0 : 1; }

std::string quad(vec2 center, Real turned) {
    return fmt::format(
        "[[shape]]\ntype = \"quad\"\nmaterial = \"tiles\"\ncenter = [{}, {}, 0]\nu = [{}, {}, 0]\nv = [{}, {}, 0]\n",
        center.x, center.y, std::cos(turned), std::sin(turned), -1.5 * std::sin(turned), 1.5 * std::cos(turned));
}

int odd(Real x) { return int(std::abs(std::floor(x / square))) % 2; }

}  // namespace

TEST_CASE("the squares of a quad begin at its centre and run along its edges", "[checker]") {
    const vec2 center(0.13, -0.21);
    const Real turned = 0.4;
    const Image image = picture(quad(center, turned));
    int of[2] = {0, 0};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const vec2 p = seen(x, y) - center;
            const vec2 on(std::cos(turned) * p.x + std::sin(turned) * p.y,
                          std::cos(turned) * p.y - std::sin(turned) * p.x);
            const bool there = std::abs(on.x) < 1 && std::abs(on.y) < 1.5;
            const int due = there ? (odd(on.x) + odd(on.y)) % 2 : -1;
            CAPTURE(x, y, on.x, on.y);
            REQUIRE(shade(image.at(x, y)) == due);
            if (there) ++of[due];
            if (due == 1) REQUIRE(largest(image.at(x, y) - Color(0, 0.75, 1)) < 1e-4);
            if (due == 0) REQUIRE(largest(image.at(x, y) - Color(0.25, 0.5, 0)) < 1e-4);
        }
    CHECK(of[0] > 1000);
    CHECK(of[1] > 1000);
}

TEST_CASE("a ball is cut from cubes about its middle", "[checker]") {
    const Image image =
        picture("[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, -1]\nradius = 1\nmaterial = \"tiles\"\n");
    int others = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            // the ray from (0, 0, 10) through (s, 0), its first root
            const vec3 d = vec3(seen(x, y), -10), o(0, 0, 11);
            const Real a = dot(d, d), b = dot(o, d), rest = b * b - a * (dot(o, o) - 1);
            if (rest < 0.05) continue;
            const vec3 p = o + (-b - std::sqrt(rest)) / a * d + square / 2;
            const int due = (odd(p.x) + odd(p.y) + odd(p.z)) % 2;
            CAPTURE(x, y);
            REQUIRE(shade(image.at(x, y)) == due);
            others += due;
        }
    CHECK(others > 300);
}

TEST_CASE("squares move along with their shape", "[checker]") {
    const char* const shapes[] = {
        "[[shape]]\ntype = \"quad\"\ncenter = [{0}, 0, 0]\nu = [1, 0.1, 0]\nv = [-0.1, 1, 0]\n",
        "[[shape]]\ntype = \"sphere\"\ncenter = [{0}, 0, 0]\nradius = 1\n",
        "[[shape]]\ntype = \"disc\"\ncenter = [{0}, 0, 0]\nradius = 1\nnormal = [0, 0.1, 1]\n",
    };
    for (const char* shape : shapes) {
        CAPTURE(shape);
        const std::string tiles = "material = \"tiles\"\n";
        const Image there = picture(fmt::format(fmt::runtime(shape), 0.5) + tiles);
        const std::string moves = fmt::format(fmt::runtime(shape), 0.25) + tiles + "velocity = [0.25, 0, 0]\n";
        // shut at one time, the shape is laid out where it is then; else each ray has a time of its own
        for (const char* shutter : {"[shutter]\nopen = 1\n", "[shutter]\nopen = 1\nclose = 1.0000001\n"}) {
            const Image moved = picture(moves, shutter);
            int differ = 0;
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) differ += shade(moved.at(x, y)) != shade(there.at(x, y));
            CHECK(differ <= 3);
        }
    }
}

TEST_CASE("where the first albedo is black, the other still reflects", "[checker]") {
    Scene scene = parse_scene(
        "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nsize = [8, 8]\n[materials.m]\n"
        "checker = { albedo = 1, size = 0.01 }\n[materials.lamp]\nemission = 1\n" +
            std::string("[[shape]]\ntype = \"quad\"\ncenter = [0, 0, 0]\nu = [9, 0, 0]\nv = [0, 9, 0]\n"
                        "material = \"m\"\n[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 9]\nradius = 1\n"
                        "material = \"lamp\"\n"),
        "scene.toml");
    CHECK(make_plan(scene).diffuse);
    CHECK(make_plan(scene).light);
    for (Material& m : scene.materials) m.checker.reset();
    CHECK(!make_plan(scene).light);
    CHECK(!make_plan(scene).checker);
}
