#include "rt/media/bodies.h"

#include <map>

namespace rt {
namespace {

void include_shape(Box& box, const Sphere& s) { box.include(Box{s.center - s.radius, s.center + s.radius}); }
void include_shape(Box& box, const Disc& d) { box.include(Box{d.center - d.radius, d.center + d.radius}); }
void include_shape(Box& box, const Triangle& t) { box.include(t.a), box.include(t.b), box.include(t.c); }
void include_shape(Box& box, const Quad& q) {
    const vec3 half = glm::abs(q.u) + glm::abs(q.v);
    box.include(Box{q.center - half, q.center + half});
}

bool scatters(const Material& m) {
    return m.transmittance != Color(0) && m.medium.extinction > 0 && m.medium.albedo != Color(0);
}

}  // namespace

std::vector<Body> scattering_bodies(const Scene& scene) {
    std::vector<Body> bodies;
    std::map<int, Box> flat;
    for (const Shape& shape : scene.shapes) {
        const Material& m = scene.materials[std::size_t(shape.material)];
        if (!scatters(m)) continue;
        Box own;
        Box& box = std::holds_alternative<Sphere>(shape.geometry) ? own : flat[shape.material];
        std::visit([&](const auto& s) { include_shape(box, s); }, shape.geometry);
        if (&box == &own) bodies.push_back({&m, own});
    }
    for (const auto& [material, box] : flat) bodies.push_back({&scene.materials[std::size_t(material)], box});
    for (const Mesh& mesh : scene.meshes) {
        const Material& m = scene.materials[std::size_t(mesh.material)];
        if (!scatters(m) || mesh.triangles.empty()) continue;
        Box box;
        for (const vec3 v : mesh.vertices) box.include(v);
        bodies.push_back({&m, box});
    }
    return bodies;
}

Real mean_scatterings(const Body& body) {
    const vec3 half = (body.box.high - body.box.low) / 2.0;
    return body.material->medium.extinction * 4 / (1 / half.x + 1 / half.y + 1 / half.z);
}

}  // namespace rt
