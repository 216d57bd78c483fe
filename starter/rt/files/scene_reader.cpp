#include "rt/files/scene_reader.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

#include "rt/files/scene_keys.h"
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

Camera read_camera(const Table& table) {
    check_keys(table, "camera");
    const auto said = read_keys(table, keys::camera);
    Camera camera{.eye = said.eye, .size = said.size, .lens_radius = said.lens_radius};
    const vec3 back = camera.eye - said.target;
    camera.back = direction(back);
    if (camera.back == vec3(0)) table.fail("target", "the camera's target is its eye", "another point");
    if (direction(said.up) == vec3(0)) table.fail("up", "'up' is zero", "the direction that is up in the image");
    const vec3 right = cross(direction(said.up), camera.back);
    if (largest(right) < 1e-9)
        table.fail(table.has("up") ? "up" : "target", "the camera looks along 'up'",
                   "an 'up' across the line of sight");
    camera.right = direction(right);
    camera.up = cross(camera.back, camera.right);
    camera.tan_half_fov = std::tan(said.vfov / 2 * (pi / 180));
    if (std::int64_t(camera.size.x) * camera.size.y > (1 << 28))
        table.fail("size", "'size' has more than 268435456 pixels", "a smaller image");
    camera.focus = said.focus ? *said.focus : std::hypot(back.x, back.y, back.z);
    return camera;
}

Shutter read_shutter(const Table& table) {
    check_keys(table, "shutter");
    const auto said = read_keys(table, keys::shutter);
    const Shutter shutter{said.open, said.close.value_or(said.open)};
    if (shutter.close < shutter.open) table.fail("close", "the shutter closes before it opens", "a later time");
    return shutter;
}

PointLight read_light(const Table& table) {
    const bool directional = read_type(table, "light") == 1;
    PointLight light = directional ? read_keys(table, keys::directional) : read_keys(table, keys::point);
    light.directional = directional;
    if (!directional) return light;
    light.position = direction(light.position);
    if (light.position == vec3(0)) table.fail("toward", "'toward' is zero", "the direction towards the light");
    return light;
}

}  // namespace

Scene read_scene(const std::string& path) { return parse_scene(read_text(path), path); }

Scene parse_scene(std::string_view text, const std::string& path) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw InputError(path + ":1:1: the file is empty; expected a scene, which has a [camera] at least");
    const Table top = Table::parse(text, path);
    check_keys(top, "");
    Scene scene = read_keys(top, keys::top);
    scene.path = path;
    if (top.has("title")) top.text("title");
    if (!top.has("camera")) top.fail("camera", "there is no camera", "[camera] with eye and target");
    const Table settings = top.table("render");
    check_keys(settings, "render");
    read_keys(settings, keys::render, scene);
    scene.camera = read_camera(top.table("camera"));
    scene.shutter = read_shutter(top.table("shutter"));
    for (const Table& light : top.tables("light")) scene.lights.push_back(read_light(light));
    read_materials(top.table("materials"), scene);
    for (const Table& shape : top.tables("shape")) read_shape(shape, scene);
    return scene;
}

}  // namespace rt
