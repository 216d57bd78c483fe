#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "rt/files/obj_reader.h"
#include "rt/files/scene_keys.h"
#include "rt/files/scene_parts.h"
#include "rt/plan.h"

namespace rt {
namespace {

int find_material(const Table& table, const std::string& name, const Scene& scene) {
    const std::vector<std::string>& names = scene.material_names;
    if (const auto found = std::ranges::find(names, name); found != names.end()) return int(found - names.begin());
    const auto nearest = nearest_word(name, names);
    table.fail("material", "there is no material " + in_quotes(name),
               nearest ? in_quotes(*nearest) + "?" : "a table [materials.NAME] of this file");
}

Triangle read_triangle(const Table& table) {
    const auto t = read_keys(table, keys::triangle);
    const vec3 normal = cross(direction(t.b - t.a), direction(t.c - t.a));
    if (largest(normal) < 1e-14) table.fail("a", "the triangle has no area", "three points that are not on one line");
    return t;
}

Quad read_quad(const Table& table) {
    const auto q = read_keys(table, keys::quad);
    const vec3 u = direction(q.u), v = direction(q.v);
    for (const char* key : {"u", "v"})
        if ((*key == 'u' ? u : v) == vec3(0)) table.fail(key, fmt::format("'{}' is zero", key), "half an edge");
    if (std::abs(dot(u, v)) > 1e-6)
        table.fail("v", fmt::format("'u' and 'v' meet at a cosine of {:.3g}", dot(u, v)), "half edges at right angles");
    return q;
}

Disc read_disc(const Table& table) {
    Disc disc = read_keys(table, keys::disc);
    disc.normal = direction(disc.normal);
    if (disc.normal == vec3(0)) table.fail("normal", "'normal' is zero", "the direction that the disc faces");
    return disc;
}

/// Scales, then moves a mesh. Normals go with the inverse; a mirror image has its triangles turned round.
void transform(Mesh& mesh, vec3 scale, vec3 translate) {
    const bool mirrored = (scale.x < 0) != ((scale.y < 0) != (scale.z < 0));
    for (vec3& v : mesh.vertices) v = v * scale + translate;
    for (vec3& n : mesh.normals) n = direction(n * vec3(scale.y * scale.z, scale.z * scale.x, scale.x * scale.y));
    if (mirrored)
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    if (mirrored)
        for (vec3& n : mesh.normals) n = -n;
}

Mesh read_mesh(const Table& table, const std::string& scene_path) {
    const auto said = read_keys(table, keys::mesh);
    const auto path = std::filesystem::path(scene_path).parent_path() / said.file;
    Mesh mesh;
    try {
        mesh = read_obj(path.string(), said.smooth);
    } catch (const std::system_error& error) {
        table.fail("file", fmt::format("{} cannot be read: {}", in_quotes(said.file), error.code().message()),
                   "an OBJ file, its path relative to this file");
    }
    transform(mesh, said.scale, said.translate);
    return mesh;
}

void check_lamp(const Table& table, const Shape& shape, const Scene& scene) {
    if (aim_at(shape, scene.materials[std::size_t(shape.material)]) != Aim::impossible) return;
    const char* what = std::holds_alternative<Triangle>(shape.geometry) ? "a triangle or mesh" : "a moving shape";
    table.fail("material", fmt::format("shadow rays cannot look for {} that shines", what),
               fmt::format("sampled = false in material {}, or a quad, disc or sphere that stands still",
                           in_quotes(name_of_material(scene, shape.material))));
}

}  // namespace

vec3 direction(vec3 v) {
    const Real size = largest(v);
    if (!(size > 0)) return vec3(0);
    const int exponent = -std::ilogb(size);
    return unit({std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)});
}

void read_shape(const Table& table, Scene& scene) {
    enum { sphere, triangle, quad, disc, mesh };
    const int type = read_type(table, "shape");
    const auto said = read_keys(table, keys::shape);
    Shape shape{{}, find_material(table, said.material, scene), said.velocity};
    if (type == triangle || type == mesh) shape.geometry = Triangle{};
    check_lamp(table, shape, scene);
    if (type == mesh) {
        scene.meshes.push_back(read_mesh(table, scene.path));
        scene.meshes.back().material = shape.material;
        scene.meshes.back().velocity = shape.velocity;
        return;
    }
    if (type == sphere) shape.geometry = read_keys(table, keys::sphere);
    if (type == triangle) shape.geometry = read_triangle(table);
    if (type == quad) shape.geometry = read_quad(table);
    if (type == disc) shape.geometry = read_disc(table);
    scene.shapes.push_back(shape);
}

}  // namespace rt
