#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "rt/parts.h"

/// A scene as plain data.
namespace rt {

struct Shape {
    std::variant<Sphere, Triangle, Quad, Disc> geometry;
    int material = 0;
    vec3 velocity{0};  // [m/s]
};

/// The shape as shadow rays look for it.
inline Emitter emitter(const Sphere& s, Color radiance) { return {Emitter::Kind::sphere, {}, {}, s, radiance}; }
inline Emitter emitter(const Quad& q, Color radiance) { return {Emitter::Kind::quad, q, {}, {}, radiance}; }
inline Emitter emitter(const Disc& d, Color radiance) { return {Emitter::Kind::disc, {}, d, {}, radiance}; }

/// Triangles that share vertices. Has one normal a vertex, or none: then each triangle is flat.
struct Mesh {
    std::vector<vec3> vertices;
    std::vector<vec3> normals;
    std::vector<glm::ivec3> triangles;
    int material = 0;
    vec3 velocity{0};  // [m/s]
};

enum class Sampler { uniform, random, stratified, sobol, orthogonal, blue_noise };
constexpr std::array<std::string_view, 6> sampler_names{"uniform", "random",     "stratified",
                                                        "sobol",   "orthogonal", "blue_noise"};

inline std::optional<Sampler> sampler_named(std::string_view name) {
    const auto found = std::find(sampler_names.begin(), sampler_names.end(), name);
    return found == sampler_names.end() ? std::nullopt : std::optional(Sampler(found - sampler_names.begin()));
}

struct Scene {
    std::string path;  // where it was read from
    Camera camera;
    Shutter shutter;
    std::vector<Material> materials;
    std::vector<std::string> material_names;  // of each; none where no file has named them
    std::vector<Shape> shapes;
    std::vector<Mesh> meshes;
    std::vector<PointLight> lights;
    Color ambient{0};      // I_a
    Color environment{0};  // radiance from infinitely far away, in every direction
    Color background{0};   // what a camera ray sees that meets nothing, where there is no environment; lights nothing

    int samples = 16;  // a pixel
    int bounces = 0;   // diffuse bounces after the first surface
    int depth = 16;    // mirrors, glass and lobes on one path
    Sampler sampler = Sampler::orthogonal;
    // How lamps are sampled. Not said: the plan decides.
    std::optional<bool> multiple_importance;  // for glossy lobes too, and both ways are weighed
    std::optional<bool> solid_angle;          // quads by solid angle, not by area
    std::optional<bool> one_lamp;             // of many lamps one is chosen at each point, at random
    std::optional<bool> media_lit;            // lamps are looked for where a medium scatters
    std::optional<bool> roulette;             // paths that carry little end at random
    Real exposure = 1;                        // factor for previews only
};

inline std::string name_of_material(const Scene& scene, int i) {
    return std::size_t(i) < scene.material_names.size() ? scene.material_names[std::size_t(i)] : std::string();
}

}  // namespace rt
