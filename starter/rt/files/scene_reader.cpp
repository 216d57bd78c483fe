#include "rt/files/scene_reader.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

#include "rt/files/scene_parts.h"
#include "rt/files/toml_table.h"

namespace rt {
namespace {

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const auto fail = [&](int error) {
        throw InputError(fmt::format("{}:1:1: cannot be read: {}; expected a scene file", path,
                                     std::generic_category().message(error)));
    };
    if (!file) fail(errno);
    file.peek();
    if (file.bad()) fail(EISDIR);
    return {std::istreambuf_iterator<char>(file), {}};
}

void read_settings(const Table& settings, Scene& scene) {
    settings.only(
        {"samples", "bounces", "depth", "sampler", "multiple_importance", "solid_angle", "one_lamp", "exposure"});
    scene.samples = settings.integer("samples", 1, 1 << 30, scene.samples);
    scene.bounces = settings.integer("bounces", 0, 1 << 24, scene.bounces);
    scene.depth = settings.integer("depth", 0, 1 << 24, scene.depth);
    scene.sampler = Sampler(settings.choice("sampler", sampler_names, int(scene.sampler)));
    const auto if_said = [&](std::string_view key, std::optional<bool>& option) {
        if (settings.has(key)) option = settings.flag(key, false);
    };
    if_said("multiple_importance", scene.multiple_importance);
    if_said("solid_angle", scene.solid_angle);
    if_said("one_lamp", scene.one_lamp);
    scene.exposure = settings.number("exposure", positive, scene.exposure);
}

Camera read_camera(const Table& table) {
    table.only({"eye", "target", "up", "vfov", "size", "lens_radius", "focus"});
    Camera camera;
    camera.eye = table.vector("eye", any_number);
    const vec3 back = camera.eye - table.vector("target", any_number);
    const vec3 up = table.vector("up", any_number, vec3(0, 1, 0));
    camera.back = direction(back);
    if (camera.back == vec3(0)) table.fail("target", "the camera's target is its eye", "another point");
    if (direction(up) == vec3(0)) table.fail("up", "'up' is zero", "the direction that is up in the image");
    const vec3 right = cross(direction(up), camera.back);
    if (largest(right) < 1e-9)
        table.fail(table.has("up") ? "up" : "target", "the camera looks along 'up'",
                   "an 'up' across the line of sight");
    camera.right = direction(right);
    camera.up = cross(camera.back, camera.right);

    constexpr Limits angle{[](Real x) { return x > 0 && x < 180; }, "an angle between 0 and 180 degrees"};
    camera.tan_half_fov = std::tan(table.number("vfov", angle, 40) / 2 * (pi / 180));
    camera.size = table.pair("size", 1, 65536, camera.size);
    if (std::int64_t(camera.size.x) * camera.size.y > (1 << 28))
        table.fail("size", "'size' has more than 268435456 pixels", "a smaller image");
    camera.lens_radius = table.number("lens_radius", not_negative, 0);
    camera.focus = table.number("focus", positive_or_inf, std::hypot(back.x, back.y, back.z));
    return camera;
}

Shutter read_shutter(const Table& table) {
    table.only({"open", "close"});
    Shutter shutter;
    shutter.open = table.number("open", any_number, 0);
    shutter.close = table.number("close", any_number, shutter.open);
    if (shutter.close < shutter.open) table.fail("close", "the shutter closes before it opens", "a later time");
    return shutter;
}

PointLight read_light(const Table& table) {
    PointLight light;
    light.directional = table.choice("type", {"point", "directional"}) == 1;
    if (light.directional) {
        table.only({"type", "toward", "irradiance"});
        light.position = direction(table.vector("toward", any_number));
        if (light.position == vec3(0)) table.fail("toward", "'toward' is zero", "the direction towards the light");
        light.intensity = table.color("irradiance", not_negative);
    } else {
        table.only({"type", "position", "intensity"});
        light.position = table.vector("position", any_number);
        light.intensity = table.color("intensity", not_negative);
    }
    return light;
}

}  // namespace

Scene read_scene(const std::string& path) { return parse_scene(read_text(path), path); }

Scene parse_scene(std::string_view text, const std::string& path) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw InputError(path + ":1:1: the file is empty; expected a scene, which has a [camera] at least");
    const Table top = Table::parse(text, path);
    top.only({"title", "render", "camera", "shutter", "ambient", "environment", "background", "materials", "light",
              "shape"});
    Scene scene;
    scene.path = path;
    if (top.has("title")) top.text("title");
    if (!top.has("camera")) top.fail("camera", "there is no camera", "[camera] with eye and target");
    read_settings(top.table("render"), scene);
    scene.camera = read_camera(top.table("camera"));
    scene.shutter = read_shutter(top.table("shutter"));
    scene.ambient = top.color("ambient", not_negative, Color(0));
    scene.environment = top.color("environment", radiance, Color(0));
    scene.background = top.color("background", radiance, Color(0));
    for (const Table& light : top.tables("light")) scene.lights.push_back(read_light(light));
    read_materials(top.table("materials"), scene);
    for (const Table& shape : top.tables("shape")) read_shape(shape, scene);
    return scene;
}

}  // namespace rt
