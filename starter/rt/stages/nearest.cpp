#include "rt/shaft.h"
#include "rt/stages/stages.h"

namespace rt {
namespace {

/// Where a ray meets a disc, from either side: t with near < t < far, else inf.
inline Real hit_disc(const Disc& disc, const Ray& ray) {
    const vec3 middle = disc.center - ray.origin;
    const Real t = dot(middle, disc.normal) / dot(ray.direction, disc.normal);
    const vec3 p = t * ray.direction - middle;
    if (!(dot(p, p) <= disc.radius * disc.radius)) return inf;
    return ray.near < t && t < ray.far ? t : inf;
}

inline Sphere at_time(Sphere s, vec3 velocity, Real time) {
    return {moved(s.center, velocity, time), s.radius};
}
inline Quad at_time(Quad q, vec3 velocity, Real time) {
    return {moved(q.center, velocity, time), q.u, q.v};
}
inline Disc at_time(Disc d, vec3 velocity, Real time) {
    return {moved(d.center, velocity, time), d.normal, d.radius};
}
inline Triangle at_time(Triangle t, vec3 velocity, Real time) {
    return {moved(t.a, velocity, time), moved(t.b, velocity, time), moved(t.c, velocity, time)};
}

/// One shape against all rays of a batch. Of two shapes at one distance the first is hit, the one with the lower
/// number.
template <auto hit, bool moves, class Shape>
void try_shape(const Numbered<Shape>& in_memory, Batch& b) {
    const Shape shape = in_memory.shape;
    const vec3 velocity = in_memory.velocity;
    const Index id = in_memory.id;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Ray ray = b.ray(i);
        Real t;
        if constexpr (moves)
            t = hit(at_time(shape, velocity, b.time[i]), ray);
        else
            t = hit(shape, ray);
        const bool closer = t < ray.far;
        b.far[i] = closer ? t : ray.far;
        b.shape[i] = closer ? id : b.shape[i];
    }
}

template <auto hit, class Shape>
void try_shapes(const std::vector<Numbered<Shape>>& shapes, const Shaft& shaft, Batch& b) {
    for (const auto& s : shapes)
        if (may_meet(shaft, s.box)) with_flag(s.velocity != vec3(0), [&](auto moves) { try_shape<hit, moves()>(s, b); });
}

/// One shape against one ray, at the ray's time.
template <auto hit, class Shape>
Real distance_to(const Numbered<Shape>& s, const Ray& ray, Real time) {
    return s.velocity == vec3(0) ? hit(s.shape, ray) : hit(at_time(s.shape, s.velocity, time), ray);
}

/// The shapes are in the tree list by list: spheres, triangles, quads, discs.
void search_tree(const World& world, bool any, Batch& b) {
    const std::uint32_t spheres = std::uint32_t(world.spheres.size());
    const std::uint32_t triangles = spheres + std::uint32_t(world.triangles.size());
    const std::uint32_t quads = triangles + std::uint32_t(world.quads.size());
    for (int i = 0; i < b.count; ++i) {
        if (!(b.far[i] > b.near[i])) continue;
        Ray ray = b.ray(i);
        const Real time = b.time[i];
        traverse(world.bvh, ray, [&](std::uint32_t item, Real) {
            Real t;
            Index id;
            if (item < spheres) {
                t = distance_to<hit_sphere>(world.spheres[item], ray, time), id = world.spheres[item].id;
            } else if (item < triangles) {
                const auto& s = world.triangles[item - spheres];
                t = distance_to<hit_triangle>(s, ray, time), id = s.id;
            } else if (item < quads) {
                const auto& s = world.quads[item - triangles];
                t = distance_to<hit_quad>(s, ray, time), id = s.id;
            } else {
                const auto& s = world.discs[item - quads];
                t = distance_to<hit_disc>(s, ray, time), id = s.id;
            }
            if (t < b.far[i] || (t == b.far[i] && id < b.shape[i])) {
                b.far[i] = t;
                b.shape[i] = id;
                // The next shape is tried up to and with this distance, for the lowest number wins a tie.
                ray.far = std::nextafter(t, inf);
            }
            return any && b.shape[i] != nothing ? -inf : b.far[i];
        });
    }
}

void search(const World& world, bool any, Batch& b) {
    if (world.plan.bvh) return search_tree(world, any, b);
    const Shaft shaft = shaft_of(b);
    if (shaft.empty()) return;
    try_shapes<hit_sphere>(world.spheres, shaft, b);
    try_shapes<hit_triangle>(world.triangles, shaft, b);
    try_shapes<hit_quad>(world.quads, shaft, b);
    try_shapes<hit_disc>(world.discs, shaft, b);
}

}  // namespace

void nearest_stage(const World& world, Batch& batch) { search(world, false, batch); }

void any_hit_stage(const World& world, Batch& batch) { search(world, true, batch); }

}  // namespace rt
