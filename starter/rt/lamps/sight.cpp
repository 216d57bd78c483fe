#include "rt/lamps/sight.h"

#include "rt/sampler.h"

namespace rt {
namespace {

/// A line of sight. Where it meets a shape, and the normal there; inf: nowhere. Not by fragments: the plan must not
/// depend on them. Triangles are left out: what lies about them is as near to the lamps.
struct Sight {
    vec3 origin, direction;

    std::pair<Real, vec3> meets(const Sphere& s) const {
        const vec3 to = s.center - origin;
        const Real middle = dot(to, direction), square = sqr(middle) - dot(to, to) + sqr(s.radius);
        return {square > 0 ? middle - std::sqrt(square) : inf, unit((middle - safe_sqrt(square)) * direction - to)};
    }
    std::pair<Real, vec3> meets(const Quad& q) const {
        const vec3 n = unit(cross(q.u, q.v));
        const Real t = to_plane(q.center, n);
        const vec3 p = origin + t * direction - q.center;
        return {std::abs(dot(p, q.u)) <= dot(q.u, q.u) && std::abs(dot(p, q.v)) <= dot(q.v, q.v) ? t : inf, n};
    }
    std::pair<Real, vec3> meets(const Disc& d) const {
        const Real t = to_plane(d.center, d.normal);
        const vec3 p = origin + t * direction - d.center;
        return {dot(p, p) <= sqr(d.radius) ? t : inf, d.normal};
    }
    static std::pair<Real, vec3> meets(const Triangle&) { return {inf, vec3(0)}; }

private:
    Real to_plane(vec3 center, vec3 n) const { return dot(center - origin, n) / dot(direction, n); }
};

/// from  the shape on which the line starts
void add_first_met(const Scene& scene, const Sight& sight, const Shape* from, std::vector<Point>& points) {
    Real nearest = inf;
    Point point{};
    for (const Shape& shape : scene.shapes) {
        const auto [t, n] = std::visit([&](const auto& s) { return sight.meets(s); }, shape.geometry);
        if (!(t > 0 && t < nearest) || &shape == from) continue;
        nearest = t, point.shape = &shape;
        point.normal = dot(n, sight.direction) > 0 ? -n : n;
        point.material = &scene.materials[std::size_t(shape.material)];
    }
    point.place = sight.origin + nearest * sight.direction, point.to_viewer = -sight.direction;
    if (nearest < inf) points.push_back(point);
}

/// Some triangles of a mesh that face the eye, whether or not something is before them.
void add_mesh(const Scene& scene, const Mesh& mesh, std::size_t most, std::vector<Point>& points) {
    const std::size_t step = mesh.triangles.size() / most + 1;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += step) {
        const glm::ivec3 corners = mesh.triangles[k];
        const vec3 a = mesh.vertices[std::size_t(corners.x)], b = mesh.vertices[std::size_t(corners.y)],
                   c = mesh.vertices[std::size_t(corners.z)];
        const vec3 place = (a + b + c) / 3.0, n = unit(cross(b - a, c - a)), to_viewer = unit(scene.camera.eye - place);
        if (dot(n, to_viewer) > 0)
            points.push_back({place, n, to_viewer, &scene.materials[std::size_t(mesh.material)], nullptr});
    }
}

}  // namespace

View view_of(const Scene& scene, int side) {
    const Camera& c = scene.camera;
    View view{side, {}, {}};
    for (int k = 0; k < side * side; ++k) {
        const vec2 film{(2 * (k % side) + 1.0) / side - 1, 1 - (2 * (k / side) + 1.0) / side};
        const vec2 slope = c.tan_half_fov * vec2(film.x * c.size.x / c.size.y, film.y);
        const std::size_t before = view.points.size();
        add_first_met(scene, {c.eye, unit(slope.x * c.right + slope.y * c.up - c.back)}, nullptr, view.points);
        view.on_film.push_back(view.points.size() > before ? int(before) : -1);
    }
    for (const Mesh& mesh : scene.meshes) add_mesh(scene, mesh, std::size_t(side * side), view.points);
    const std::size_t seen = scene.bounces > 0 ? view.points.size() : 0;
    for (std::size_t k = 0; k < seen; ++k) {
        const vec2 u = sobol_2d(1, std::uint32_t(k), 0), circle = std::sqrt(u.x) * unit_circle(u.y);
        const Point from = view.points[k];
        add_first_met(scene, {from.place, frame_about(from.normal).to_world({circle, std::sqrt(1 - u.x)})}, from.shape,
                      view.points);
    }
    return view;
}

}  // namespace rt
