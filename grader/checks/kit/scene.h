#pragma once

#include <span>
#include <string>
#include <string_view>

#include "checks/kit/draw.h"
#include "rt/scene.h"

/// Scenes as text, of a file or piece by piece: view + material("floor", {{"albedo", 0.5}}) + quad("floor", ...).
namespace grade {

/// A value as a scene file has it, with all digits.
struct SceneValue {
    std::string text;

    SceneValue(double x);
    SceneValue(int x) : text(std::to_string(x)) {}
    SceneValue(bool x) : text(x ? "true" : "false") {}
    SceneValue(rt::vec3 v);
    SceneValue(const char* raw) : text(raw) {}
};

struct SceneKey {
    const char* name;
    SceneValue value;
};
using SceneKeys = std::vector<SceneKey>;

/// scene_table("[shutter]", {{"open", 0.5}, {"close", 1.0}})
std::string scene_table(const std::string& head, const SceneKeys& keys);

/// The scene of a file beside the checks, with a value in place of each {name}: scene_from("hollow_sphere.toml",
/// {{"radius", 0.5}}). Throws rt::InputError, "file:line:column: ...", for a place without a value, a value without a
/// place, and what is no scene.
std::string scene_from(const std::string& file, const SceneKeys& values);

/// The same of a text, which need not be a scene.
std::string filled_in(std::string_view text, const std::string& path, const SceneKeys& values);

/// The files beside the checks, as the build has put them into the grader.
std::span<const std::pair<std::string_view, std::string_view>> scene_texts();

std::string material(const std::string& name, const SceneKeys& keys);
/// Something that shines and is not sampled: no shadow ray looks for it.
std::string unsampled_lamp(const std::string& name, const SceneValue& emission);
std::string environment(const SceneValue& radiance);
std::string shutter(double open, double close);
std::string point_light(rt::vec3 position, const SceneValue& intensity);
std::string directional_light(rt::vec3 toward, const SceneValue& irradiance);

/// A camera as a scene file has it.
struct View {
    rt::vec3 eye{0}, target{0}, up{0, 1, 0};
    double vfov = 40;  // [degree]
    rt::ivec2 size{32, 32};
    double lens_radius = 0, focus = 0;  // focus 0: at the target
};
std::string toml(const View& view);

/// The camera of a scene, as the renderer has it.
rt::Camera camera_of(const std::string& scene);
rt::Camera camera_of(const View& view);

std::string sphere(const std::string& material, rt::vec3 center, double radius, rt::vec3 velocity = rt::vec3(0));
std::string disc(const std::string& material, rt::vec3 center, rt::vec3 normal, double radius,
                 rt::vec3 velocity = rt::vec3(0));
std::string quad(const std::string& material, rt::vec3 center, rt::vec3 u, rt::vec3 v, rt::vec3 velocity = rt::vec3(0));
inline std::string quad(const std::string& material, const rt::Quad& q) { return quad(material, q.center, q.u, q.v); }
std::string triangle(const std::string& material, rt::vec3 a, rt::vec3 b, rt::vec3 c);

/// A scene is set up in a frame of its own, and stands anywhere, turned in any way: place({x, y, z}) is in the world.
struct Place {
    rt::Frame axes;
    rt::vec3 origin;

    rt::vec3 operator()(rt::vec3 local) const { return origin + axes.to_world(local); }
    rt::vec3 turned(rt::vec3 local) const { return axes.to_world(local); }
    /// A square of the plane z, from -half to half, whose front is up.
    std::string floor(const std::string& material, double half, double z = 0) const;
    /// From z down to the origin; [degree]
    View from_above(double z, double vfov, rt::ivec2 size) const;
};
Place any_place(Generator& random);

/// The angle of view, in degrees, in which a half width is seen at a distance.
inline double vfov_of(double half, double distance) { return 2 * std::atan(half / distance) * 180 / rt::pi; }

/// The direction of a pinhole's ray through a film point.
rt::vec3 view_direction(const rt::Camera& camera, rt::vec2 film);

/// Where the ray through a film point meets a plane.
rt::vec3 seen_on_plane(const rt::Camera& camera, rt::vec2 film, rt::vec3 point, rt::vec3 normal);

constexpr double film_pixel = 0.01;  // [m] of the plane that such a camera sees

/// A camera that sees the plane z = 0 of a place in pixels.
View film_view(const Place& place, rt::ivec2 size);

/// A rectangle of light on the film, by its centre and half edges in pixels, y down.
std::string bright(const Place& place, rt::ivec2 size, const std::string& material, rt::vec2 center, rt::vec2 u,
                   rt::vec2 v);

}  // namespace grade
