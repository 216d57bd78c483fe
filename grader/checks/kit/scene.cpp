#include "checks/kit/scene.h"

#include <fmt/format.h>

#include "rt/files/scene_reader.h"

namespace grade {

SceneValue::SceneValue(double x) : text(fmt::format("{}", x)) {}
SceneValue::SceneValue(rt::vec3 v) : text(fmt::format("[{}, {}, {}]", v.x, v.y, v.z)) {}

std::string scene_table(const std::string& head, const SceneKeys& keys) {
    std::string text = head + "\n";
    for (const SceneKey& key : keys) text += fmt::format("{} = {}\n", key.name, key.value.text);
    return text + "\n";
}

std::string material(const std::string& name, const SceneKeys& keys) {
    return scene_table("[materials." + name + "]", keys);
}

std::string unsampled_lamp(const std::string& name, const SceneValue& emission) {
    return material(name, {{"emission", emission}, {"sampled", false}});
}

std::string environment(const SceneValue& radiance) { return fmt::format("environment = {}\n\n", radiance.text); }

std::string shutter(double open, double close) { return scene_table("[shutter]", {{"open", open}, {"close", close}}); }

std::string point_light(rt::vec3 position, const SceneValue& intensity) {
    return scene_table("[[light]]", {{"type", "\"point\""}, {"position", position}, {"intensity", intensity}});
}

std::string directional_light(rt::vec3 toward, const SceneValue& irradiance) {
    return scene_table("[[light]]", {{"type", "\"directional\""}, {"toward", toward}, {"irradiance", irradiance}});
}

std::string toml(const View& view) {
    SceneKeys keys = {{"eye", view.eye},
                      {"target", view.target},
                      {"up", view.up},
                      {"vfov", view.vfov},
                      {"size", fmt::format("[{}, {}]", view.size.x, view.size.y).c_str()}};
    if (view.lens_radius > 0) keys.push_back({"lens_radius", view.lens_radius});
    if (view.focus > 0) keys.push_back({"focus", view.focus});
    return scene_table("[camera]", keys);
}

rt::Camera camera_of(const std::string& scene) { return rt::parse_scene(scene, "scene").camera; }
rt::Camera camera_of(const View& view) { return camera_of(toml(view) + material("none", {})); }

namespace {

std::string shape(const char* type, SceneKeys keys, const std::string& material, rt::vec3 velocity) {
    keys.insert(keys.begin(), {"type", type});
    keys.push_back({"material", ('"' + material + '"').c_str()});
    if (velocity != rt::vec3(0)) keys.push_back({"velocity", velocity});
    return scene_table("[[shape]]", keys);
}

}  // namespace

std::string sphere(const std::string& material, rt::vec3 center, double radius, rt::vec3 velocity) {
    return shape("\"sphere\"", {{"center", center}, {"radius", radius}}, material, velocity);
}

std::string disc(const std::string& material, rt::vec3 center, rt::vec3 normal, double radius, rt::vec3 velocity) {
    return shape("\"disc\"", {{"center", center}, {"normal", normal}, {"radius", radius}}, material, velocity);
}

std::string quad(const std::string& material, rt::vec3 center, rt::vec3 u, rt::vec3 v, rt::vec3 velocity) {
    return shape("\"quad\"", {{"center", center}, {"u", u}, {"v", v}}, material, velocity);
}

std::string triangle(const std::string& material, rt::vec3 a, rt::vec3 b, rt::vec3 c) {
    return shape("\"triangle\"", {{"a", a}, {"b", b}, {"c", c}}, material, rt::vec3(0));
}

std::string Place::floor(const std::string& material, double half, double z) const {
    return quad(material, (*this)({0, 0, z}), half * axes.x, half * axes.y);
}

View Place::from_above(double z, double vfov, rt::ivec2 size) const {
    return {(*this)({0, 0, z}), (*this)({0, 0, 0}), turned({0, 1, 0}), vfov, size};
}

Place any_place(Generator& random) {
    const rt::vec3 z = direction(random);
    const rt::vec3 x = tilted(random, z, rt::pi / 2);
    return {{x, rt::cross(z, x), z}, box(random, -2, 2)};
}

rt::vec3 view_direction(const rt::Camera& camera, rt::vec2 film) {
    const double scale = 2 * camera.tan_half_fov / camera.size.y;
    return rt::unit(scale * (film.x - 0.5 * camera.size.x) * camera.right -
                    scale * (film.y - 0.5 * camera.size.y) * camera.up - camera.back);
}

rt::vec3 seen_on_plane(const rt::Camera& camera, rt::vec2 film, rt::vec3 point, rt::vec3 normal) {
    const rt::vec3 d = view_direction(camera, film);
    return camera.eye + rt::dot(point - camera.eye, normal) / rt::dot(d, normal) * d;
}

View film_view(const Place& place, rt::ivec2 size) {
    return place.from_above(5, vfov_of(size.y * film_pixel / 2, 5), size);
}

std::string bright(const Place& place, rt::ivec2 size, const std::string& material, rt::vec2 center, rt::vec2 u,
                   rt::vec2 v) {
    const auto turned = [&](rt::vec2 d) { return place.turned(film_pixel * rt::vec3(d.x, -d.y, 0)); };
    const rt::vec2 c = center - 0.5 * rt::vec2(size);
    const rt::vec3 across = turned(u), along = turned(v);
    // the front side faces the camera
    const bool faces = rt::dot(rt::cross(across, along), place.axes.z) > 0;
    return quad(material, place(film_pixel * rt::vec3(c.x, -c.y, 0)), across, faces ? along : -along);
}

}  // namespace grade
