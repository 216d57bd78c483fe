#include <array>

#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::Ray, rt::Triangle, rt::vec3;

/// A closed mesh of eight triangles: an octahedron with crooked corners, about a point.
std::array<Triangle, 8> octahedron(Generator& random, vec3 center, double size) {
    const rt::Frame frame = rt::frame_about(direction(random));
    std::array<vec3, 6> corners;
    for (std::size_t i = 0; i < 6; ++i) {
        const vec3 axis = i < 2 ? frame.x : i < 4 ? frame.y : frame.z;
        const double out = between(random, 0.7, 1.4);  // drawn first: the terms of a sum have no order
        corners[i] = center + size * (out * (i % 2 ? -axis : axis) + box(random, -0.2, 0.2));
    }
    std::array<Triangle, 8> faces;
    for (std::size_t i = 0; i < 8; ++i) faces[i] = {corners[i & 1], corners[2 + (i >> 1 & 1)], corners[4 + (i >> 2)]};
    return faces;
}

/// The share of 240 rays from within that find no way to the mesh.
///
/// at_edges  aimed at points of edges and at corners, else at random
double missed(vec3 center, double size, bool at_edges, Generator& random, const Asker& ask) {
    constexpr int meshes = 8, rays = 30;
    Rows rows;
    for (int mesh = 0; mesh < meshes; ++mesh) {
        const auto faces = octahedron(random, center, size);
        for (int i = 0; i < rays; ++i) {
            const vec3 origin = center + size * box(random, -0.05, 0.05);
            const Triangle& face = faces[std::size_t(whole_between(random, 0, 7))];
            const double s = i % 10 == 0 ? 0 : between(random, 0, 1);
            const vec3 target = face.a + s * (face.b - face.a);
            const vec3 d = at_edges ? target - origin : direction(random);
            for (const Triangle& each : faces) rows.push_back(row(each, Ray{origin, rt::unit(d), 0, rt::inf}));
        }
    }
    const Rows out = ask.probe("hit_triangle", rows);
    int lost = 0;
    for (std::size_t ray = 0; ray < meshes * rays; ++ray) {
        bool found = false;
        for (std::size_t k = 0; k < 8; ++k) {
            if (std::isnan(out[8 * ray + k].at(0))) return rt::inf;
            found |= std::isfinite(out[8 * ray + k][0]);
        }
        lost += !found;
    }
    return double(lost) / (meshes * rays);
}

/// Of a mesh of size x, or of one at a distance x.
Measure missed_by(bool far, bool at_edges) {
    return [=](double x, Generator& random, const Asker& ask) {
        return missed(far ? x * vec3(0.7, 0.1, -0.8) : vec3(0), far ? 2 : x, at_edges, random, ask);
    };
}

}  // namespace

std::vector<Family> mesh_families() {
    return {Family("mesh_scale", {"hit_triangle"}, "size of a closed mesh [m]", "share of rays that get out",
                   {.tolerance = 0, .decades = sweep(-60, 60, 3)}, missed_by(false, false)),
            Family("mesh_edges", {"hit_triangle"}, "size of a closed mesh [m]", "share of rays at edges that get out",
                   {.tolerance = 0, .decades = sweep(-12, 12), .scored = {}}, missed_by(false, true)),
            Family("mesh_far", {"hit_triangle"}, "distance of a mesh from the world's origin [m]",
                   "share of rays that get out", {.tolerance = 0, .decades = sweep(0, 12), .scored = {0, 3}},
                   missed_by(true, false)),
            Family("mesh_far_edges", {"hit_triangle"}, "distance of a mesh from the world's origin [m]",
                   "share of rays at edges that get out", {.tolerance = 0, .decades = sweep(0, 12), .scored = {}},
                   missed_by(true, true))};
}

}  // namespace grade::stress
