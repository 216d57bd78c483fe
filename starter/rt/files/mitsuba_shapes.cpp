#include <fmt/format.h>

#include "rt/files/mitsuba_parts.h"

namespace rt {
namespace {

/// The transform whose axes and origin are these.
std::string to_world(vec3 x, vec3 y, vec3 z, vec3 origin) {
    std::string rows;
    for (int i = 0; i < 3; ++i) rows += fmt::format("{:.10g} {:.10g} {:.10g} {:.10g} ", x[i], y[i], z[i], origin[i]);
    return "<transform name=\"to_world\"><matrix value=\"" + rows + "0 0 0 1\"/></transform>";
}

std::string geometry(const Sphere& s) {
    return "\"sphere\">" + xml_point("center", s.center) + xml_number("radius", s.radius);
}

std::string geometry(const Quad& q) { return "\"rectangle\">" + to_world(q.u, q.v, unit(cross(q.u, q.v)), q.center); }

std::string geometry(const Disc& d) {
    const Frame f = frame_about(d.normal);
    return "\"disk\">" + to_world(d.radius * f.x, d.radius * f.y, d.normal, d.center);
}

std::string geometry(const Triangle&) { return {}; }  // all of a material's become a mesh

Shape moved_to(Shape shape, Real time) {
    const vec3 shift = time * shape.velocity;
    std::visit(
        [&](auto& s) {
            if constexpr (std::is_same_v<std::decay_t<decltype(s)>, Triangle>)
                s.a += shift, s.b += shift, s.c += shift;
            else
                s.center += shift;
        },
        shape.geometry);
    return shape;
}

/// A mesh as a PLY file. Single precision is what Mitsuba computes with.
std::string ply(const Mesh& mesh, vec3 shift) {
    const bool smooth = !mesh.normals.empty();
    std::string text = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", mesh.vertices.size());
    text += "property float x\nproperty float y\nproperty float z\n";
    if (smooth) text += "property float nx\nproperty float ny\nproperty float nz\n";
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const vec3 p = mesh.vertices[i] + shift;
        text += fmt::format("{:.9g} {:.9g} {:.9g}", p.x, p.y, p.z);
        if (smooth)
            text += fmt::format(" {:.9g} {:.9g} {:.9g}", mesh.normals[i].x, mesh.normals[i].y, mesh.normals[i].z);
        text += "\n";
    }
    for (const glm::ivec3 t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t.x, t.y, t.z);
    return text;
}

/// The triangles that are shapes of their own, as one mesh for each material.
std::vector<Mesh> loose_triangles(const Scene& scene) {
    std::vector<Mesh> meshes(scene.materials.size());
    for (const Shape& in_scene : scene.shapes) {
        const Shape shape = moved_to(in_scene, scene.shutter.open);
        const Triangle* t = std::get_if<Triangle>(&shape.geometry);
        if (!t) continue;
        Mesh& mesh = meshes[std::size_t(shape.material)];
        mesh.material = shape.material;
        const int first = int(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {t->a, t->b, t->c});
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    std::erase_if(meshes, [](const Mesh& m) { return m.triangles.empty(); });
    return meshes;
}

/// A point just before the front of a shape.
vec3 before(const Sphere& s) { return s.center + vec3(s.radius * (1 + 1e-9), 0, 0); }
vec3 before(vec3 p, vec3 normal) { return p + (1e-9 * largest(p) + 1e-15) * unit(normal); }
vec3 before(const Quad& q) { return before(q.center, cross(q.u, q.v)); }
vec3 before(const Disc& d) { return before(d.center, d.normal); }
vec3 before(const Triangle& t) { return before((t.a + t.b + t.c) / 3.0, cross(t.b - t.a, t.c - t.a)); }

/// One shape. Materials are numbered: their names may hold anything.
///
/// quad   if it is one: a checker's squares lie on each as its size asks
/// front  a point before its front: what is there is its exterior
std::string shape(const std::string& geometry, int material, const Scene& scene, const World* world, vec3 front,
                  const Quad* quad = nullptr) {
    const Material& m = scene.materials[std::size_t(material)];
    std::string xml = "  <shape type=" + geometry;
    xml += m.checker && quad ? mitsuba_surface(m, "", quad) : fmt::format("<ref id=\"material{}\"/>", material);
    if (has_medium(m)) xml += fmt::format("<ref name=\"interior\" id=\"medium{}\"/>", material);
    if (world && m.transmittance != Color(0))
        xml += mitsuba_medium_at(*world, regions_around(*world, front, scene.shutter.open), "exterior");
    if (m.emission != Color(0)) xml += "<emitter type=\"area\">" + xml_color("radiance", m.emission) + "</emitter>";
    return xml + "</shape>\n";
}

}  // namespace

void add_mitsuba_shapes(const Scene& scene, const World* world, const std::string& stem, MitsubaFiles& out) {
    for (const Shape& in_scene : scene.shapes) {
        const Shape s = moved_to(in_scene, scene.shutter.open);
        const std::string said = std::visit([](const auto& g) { return geometry(g); }, s.geometry);
        if (said.empty()) continue;
        const vec3 front = std::visit([](const auto& g) { return before(g); }, s.geometry);
        out.xml += shape(said, s.material, scene, world, front, std::get_if<Quad>(&s.geometry));
    }
    const auto add_mesh = [&](const Mesh& mesh) {
        const vec3 shift = scene.shutter.open * mesh.velocity;
        const auto corner = [&](int i) { return mesh.vertices[std::size_t(mesh.triangles[0][i])] + shift; };
        const vec3 front = mesh.triangles.empty() ? shift : before(Triangle{corner(0), corner(1), corner(2)});
        out.meshes.push_back({fmt::format("{}{}.ply", stem, out.meshes.size()), ply(mesh, shift)});
        out.xml += shape(
            fmt::format("\"ply\"><string name=\"filename\" value=\"{}\"/><boolean name=\"face_normals\" value=\"{}\"/>",
                        out.meshes.back().name, mesh.normals.empty()),
            mesh.material, scene, world, front);
    };
    for (const Mesh& mesh : loose_triangles(scene)) add_mesh(mesh);
    for (const Mesh& mesh : scene.meshes) add_mesh(mesh);
}

}  // namespace rt
