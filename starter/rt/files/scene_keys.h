#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "rt/files/toml_table.h"
#include "rt/scene.h"

/// All that a scene file may say, each key once: what reads it, its error messages, the handout's tables and the schema
/// that editors read are made of it. Nobody needs this file for the assignment.
namespace rt {

enum class Kind { number, whole, flag, text, vector, pair, color, factors, choice, table };

/// What the file says where the scene holds something else.
struct CameraWords {
    vec3 eye{0}, target{0}, up{0, 1, 0};
    Real vfov = 40;
    ivec2 size{256, 256};
    Real lens_radius = 0;
    std::optional<Real> focus;
};
struct ShutterWords {
    Real open = 0;
    std::optional<Real> close;
};
struct ShapeWords {
    std::string material;
    vec3 velocity{0};
};
struct MeshWords {
    std::string file;
    vec3 scale{1}, translate{0};
    bool smooth = false;
};

/// Where the value of a key goes; nowhere: its reader has more to do.
template <class T>
using Field = std::variant<std::monostate, Real T::*, int T::*, bool T::*, std::optional<Real> T::*,
                           std::optional<bool> T::*, vec3 T::*, ivec2 T::*, Sampler T::*, std::string T::*>;

/// What is known of a key, wherever its value goes.
struct KeyWords {
    std::string_view name;
    Kind kind = Kind::table;
    Limits limits;
    std::string_view otherwise;  // what not to say it means, as the handout has it; empty: it must be there
    std::string_view meaning, unit;
};

template <class T>
struct Key {
    std::string_view name;
    Kind kind;
    Field<T> field;
    Limits limits;
    std::string_view otherwise, meaning, unit{};
};

namespace keys {

using enum Kind;
using std::monostate;

inline constexpr Limits any = any_number;
inline constexpr Limits most_samples{1, 1 << 30}, most_waves{0, 1 << 24}, side{1, 65536};
inline constexpr Limits angle{.low = 0, .high = 180, .above = true, .below = true};
inline constexpr Limits cosine{.low = -1, .high = 1, .above = true, .below = true};
inline constexpr Limits exponent{.low = 0, .or_inf = true};
inline constexpr Limits factor{.low = -1e30, .high = 1e30, .least = 1e-30};

inline constexpr Key<Scene> top[] = {
    {"title", text, monostate(), any, "no title", "for people"},
    {"ambient", color, &Scene::ambient, not_negative, "0",
     "ambient light I_a of the Phong model; only materials with `ambient` answer it"},
    {"environment", color, &Scene::environment, radiance, "0",
     "radiance that arrives from infinitely far away, from every direction", "W/(sr m²)"},
    {"background", color, &Scene::background, radiance, "0",
     "what a camera ray sees that meets nothing, where there is no environment; lights nothing", "W/(sr m²)"},
    {"render", table, monostate(), any, "none", "see below"},
    {"camera", table, monostate(), any, "", "see below"},
    {"shutter", table, monostate(), any, "none", "see below"},
    {"materials", table, monostate(), any, "none", "see below, each by its name"},
    {"light", table, monostate(), any, "none", "see below, as many as there are"},
    {"shape", table, monostate(), any, "none", "see below, as many as there are"},
};

inline constexpr Key<Scene> render[] = {
    {"samples", whole, &Scene::samples, most_samples, "16", "samples a pixel"},
    {"bounces", whole, &Scene::bounces, most_waves, "0",
     "diffuse bounces after the first surface; 0: direct light only"},
    {"depth", whole, &Scene::depth, most_waves, "16",
     "mirrors, glass and lobes on one path; above 24 each ray goes on as one, mirrored or refracted, never as both"},
    {"sampler", choice, &Scene::sampler, any, "`\"orthogonal\"`",
     "the pattern of the samples. `stratified`: each dimension by itself; `sobol`: Owen-scrambled Sobol' points, pair "
     "by pair; `orthogonal`: even between any two dimensions; where `samples` is no power of four up to 256, `sobol`; "
     "`blue_noise`: as `sobol`, but the errors of neighbours cancel, so that few samples look like fine grain"},
    {"multiple_importance", flag, &Scene::multiple_importance, any, "the plan decides",
     "lamps are sampled for glossy lobes too, and both ways to find them are weighed: less noise. The framework "
     "evaluates the lobes then, so that a mistake in `glossy_reflection` shows less"},
    {"solid_angle", flag, &Scene::solid_angle, any, "the plan decides",
     "quads that shine are sampled by the solid angle that they fill, not by their area: less noise near large lamps. "
     "The framework does it then; `light_sample` is still asked for discs and spheres, and where a quad looks small"},
    {"one_lamp", flag, &Scene::one_lamp, any, "the plan decides",
     "at each point one lamp with extent is chosen at random, likely a bright one that is near, in place of all of "
     "them: for hundreds of lamps. Less time, which grows with the logarithm of their number, and more noise"},
    {"media_lit", flag, &Scene::media_lit, any, "the plan decides",
     "lamps with extent are looked for at each scattering in a medium whose boundary bends no light, and weighed "
     "against the directions of `scatter_direction`: less noise where lamps are small"},
    {"roulette", flag, &Scene::roulette, any, "the plan decides",
     "a path that carries little ends at random after a bounce or a scattering; those that go on carry more in its "
     "place. Less time, and more noise"},
    {"exposure", number, &Scene::exposure, positive, "1", "factor for the PNG preview; the EXR does not change"},
};

inline constexpr Key<CameraWords> camera[] = {
    {"eye", vector, &CameraWords::eye, any, "", "where the camera is", "m"},
    {"target", vector, &CameraWords::target, any, "", "the point in the middle of the image; not the eye", "m"},
    {"up", vector, &CameraWords::up, any, "`[0, 1, 0]`",
     "the direction that is up in the image; not along the line of sight"},
    {"vfov", number, &CameraWords::vfov, angle, "40", "full vertical field of view", "degree"},
    {"size", pair, &CameraWords::size, side, "`[256, 256]`", "width and height", "pixel"},
    {"lens_radius", number, &CameraWords::lens_radius, not_negative, "0", "0: a pinhole, everything is in focus", "m"},
    {"focus", number, &CameraWords::focus, positive_or_inf, "distance of `target`",
     "distance of the plane in focus, along the axis", "m"},
};

inline constexpr Key<ShutterWords> shutter[] = {
    {"open", number, &ShutterWords::open, any, "0", "when light begins to be gathered", "s"},
    {"close", number, &ShutterWords::close, any, "`open`", "when it ends; not before `open`", "s"},
};

inline constexpr Key<Material> material[] = {
    {"ambient", color, &Material::ambient, share, "0", "r_a: reflectance of the ambient light"},
    {"albedo", color, &Material::albedo, share, "0", "diffuse reflectance; r_d = albedo/π"},
    {"specular", color, &Material::specular, share, "0", "r_s: reflectance of Phong's highlight"},
    {"shininess", number, &Material::shininess, not_negative, "1", "exponent of the highlight"},
    {"reflectance", color, &Material::reflectance, share, "0",
     "of a mirror, or of the glossy lobe about the mirror direction"},
    {"transmittance", color, &Material::transmittance, share, "0",
     "of glass, or of the lobe about the refracted direction; above 0, Fresnel's law shares the light between the two, "
     "so that clear glass has `reflectance = 1` as well"},
    {"exponent", number, &Material::exponent, exponent, "`inf`", "of the lobe; `inf`: a perfect mirror, clear glass"},
    {"ior", number, &Material::ior, positive, "1", "index of refraction behind the surface; in front it is 1"},
    {"emission", color, &Material::emission, radiance, "0", "radiance that leaves the front side", "W/(sr m²)"},
    {"sampled", flag, &Material::sampled, any, "`true`",
     "whether shadow rays look for this lamp; `false`: only paths that happen to hit it"},
    {"medium", table, monostate(), any, "none", "what fills the shape: `medium = { extinction = 1, albedo = 0.9 }`"},
    {"checker", table, monostate(), any, "none",
     "a second albedo, in every other square: `checker = { albedo = 0.5, size = 1 }`"},
};

inline constexpr Key<Medium> medium[] = {
    {"extinction", number, &Medium::extinction, not_negative, "", "inverse of the mean distance that light travels",
     "1/m"},
    {"albedo", color, &Medium::albedo, share, "1", "the share of it that is scattered and not absorbed"},
    {"g", number, &Medium::g, cosine, "0", "the mean cosine of the scattering angle"},
};

inline constexpr Key<Checker> checker[] = {
    {"albedo", color, &Checker::albedo, share, "", "diffuse reflectance in those squares"},
    {"size", number, &Checker::size, positive, "", "of a square's side", "m"},
};

inline constexpr Key<PointLight> point[] = {
    {"position", vector, &PointLight::position, any, "", "where it is", "m"},
    {"intensity", color, &PointLight::intensity, not_negative, "", "to every side", "W/sr"},
};

inline constexpr Key<PointLight> directional[] = {
    {"toward", vector, &PointLight::position, any, "", "the direction towards the light, of any length"},
    {"irradiance", color, &PointLight::intensity, not_negative, "", "of a surface that faces it", "W/m²"},
};

inline constexpr Key<ShapeWords> shape[] = {
    {"material", text, &ShapeWords::material, any, "", "the NAME of a material of this file"},
    {"velocity", vector, &ShapeWords::velocity, any, "0", "of what moves; the other keys say where it is at time 0",
     "m/s"},
};

inline constexpr Key<Sphere> sphere[] = {
    {"center", vector, &Sphere::center, any, "", "of the sphere", "m"},
    {"radius", number, &Sphere::radius, positive, "", "of the sphere", "m"},
};

inline constexpr Key<Triangle> triangle[] = {
    {"a", vector, &Triangle::a, any, "", "a corner", "m"},
    {"b", vector, &Triangle::b, any, "", "a corner", "m"},
    {"c", vector, &Triangle::c, any, "", "a corner; front side: where a, b, c run anticlockwise", "m"},
};

inline constexpr Key<Quad> quad[] = {
    {"center", vector, &Quad::center, any, "", "the points of a quad are center + x u + y v, \\|x\\|, \\|y\\| ≤ 1",
     "m"},
    {"u", vector, &Quad::u, any, "", "half an edge", "m"},
    {"v", vector, &Quad::v, any, "", "half the other edge, at right angles to u; front side: u × v", "m"},
};

inline constexpr Key<Disc> disc[] = {
    {"center", vector, &Disc::center, any, "", "of the disc", "m"},
    {"normal", vector, &Disc::normal, any, "", "the direction that the front side faces, of any length"},
    {"radius", number, &Disc::radius, positive, "", "of the disc", "m"},
};

inline constexpr Key<MeshWords> mesh[] = {
    {"file", text, &MeshWords::file, any, "", "a Wavefront OBJ file: see below"},
    {"scale", factors, &MeshWords::scale, factor, "1", "first scaled, by one factor or three"},
    {"translate", vector, &MeshWords::translate, any, "0", "then moved", "m"},
    {"smooth", flag, &MeshWords::smooth, any, "`false`",
     "`true`: normals of the file, or where it has none the mean of the faces around a vertex"},
};

}  // namespace keys

/// The value of a key that is there.
void read_value(const Table& table, const KeyWords& key, Real& value);
void read_value(const Table& table, const KeyWords& key, int& value);
void read_value(const Table& table, const KeyWords& key, bool& value);
void read_value(const Table& table, const KeyWords& key, vec3& value);
void read_value(const Table& table, const KeyWords& key, ivec2& value);
void read_value(const Table& table, const KeyWords& key, Sampler& value);
void read_value(const Table& table, const KeyWords& key, std::string& value);

template <class V>
void read_value(const Table& table, const KeyWords& key, std::optional<V>& value) {
    read_value(table, key, value.emplace());
}

template <class T>
KeyWords words_of(const Key<T>& key) {
    return {key.name, key.kind, key.limits, key.otherwise, key.meaning, key.unit};
}

/// Fills in what the table says, and leaves the rest as it is. Throws InputError, also where a key is missing.
template <class T, std::size_t n>
void read_keys(const Table& table, const Key<T> (&keys)[n], T& to) {
    for (const Key<T>& key : keys)
        std::visit(
            [&](auto field) {
                if constexpr (!std::is_same_v<decltype(field), std::monostate>)
                    if (key.otherwise.empty() || table.has(key.name)) read_value(table, words_of(key), to.*field);
            },
            key.field);
}

template <class T, std::size_t n>
T read_keys(const Table& table, const Key<T> (&keys)[n]) {
    T read;
    read_keys(table, keys, read);
    return read;
}

/// The tables of a scene file and their keys: "" is the file itself, "materials.medium" a table in that of a material,
/// "shape.sphere" a type of [[shape]].
struct KeyTable {
    std::string_view name;
    std::vector<KeyWords> keys;
};

const std::vector<KeyTable>& scene_tables();

/// Throws InputError where a table has a key that is none of its own.
void check_keys(const Table& table, std::string_view name);

/// The place of a table's type among those of its name, "light" or "shape"; checks its keys too.
int read_type(const Table& table, std::string_view name);

}  // namespace rt
