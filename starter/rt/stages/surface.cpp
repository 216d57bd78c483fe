#include "rt/fragments.h"
#include "rt/stages/stages.h"

namespace rt {
namespace {

/// How far a point is from its surface, and how far above it a ray must start so that no rounding brings it back:
/// roundings of the largest number that takes part.
///
/// Source: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., section 6.8.
constexpr Real surface_error = 32 * roundoff;

/// The normal of a mesh between its corners, by the hit's areas.
vec3 smooth_normal(const World& world, Index shape, vec3 p) {
    const Triangle& t = world.triangles[std::size_t(shape - world.first_triangle)];
    const glm::ivec3 corners = world.corners[std::size_t(world.surfaces[std::size_t(shape)].smooth)];
    const vec3 n = cross(t.b - t.a, t.c - t.a);
    const Real u = dot(cross(t.c - t.b, p - t.b), n), v = dot(cross(t.a - t.c, p - t.c), n),
               w = dot(cross(t.b - t.a, p - t.a), n);
    return unit(u * world.normals[std::size_t(corners.x)] + v * world.normals[std::size_t(corners.y)] +
                w * world.normals[std::size_t(corners.z)]);
}

/// The normal of a mirror or glass, bent so far that the viewer sees its front, and that what a mirror reflects to the
/// viewer comes from above the surface: what comes from below is turned up about the surface.
///
/// n  interpolated, unit
/// g  of the surface, unit, on the side of the viewer
/// d  direction of travel, towards the surface
///
/// Source: Keller et al., "The Iray Light Transport Simulation and Rendering System", arXiv 1705.01263, 2017, appendix
/// A.3.
vec3 bent(vec3 n, vec3 g, vec3 d) {
    const vec3 mirrored = d - 2 * dot(d, n) * n;
    const Real above = dot(mirrored, g);
    if (above > 0 && dot(d, n) < 0) return n;
    const vec3 half_way = unit((above > 0 ? mirrored : mirrored - 2 * above * g) - d);
    return dot(d, half_way) < 0 ? half_way : g;
}

/// Whether no light gets through the surface of glass, at this cosine.
bool is_totally_reflected(const Material& m, bool behind, Real cosine) {
    const Real from = behind ? m.ior : 1, to = behind ? 1 : m.ior;
    return (to - from) * (to + from) + sqr(from * cosine) < 0;
}

/// What is known of the shapes that a batch meets: one: all are the shape `first`, whose record is then read once;
/// flat: it is no sphere, and there are no roots to take.
enum class Meet { any, one, flat };

template <bool time, Meet meet>
[[gnu::noinline]] void find_surfaces(const World& world, Index first, const Batch& b, Surfaces& s) {
    const SurfaceRecord* records = world.surfaces.data();
    const SurfaceRecord of_first = records[first];
    constexpr bool one = meet != Meet::any;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const bool hit = b.shape[i] >= 0;
        const SurfaceRecord& record = one ? of_first : records[hit ? b.shape[i] : 0];
        const vec3 origin = b.origin.at(i), direction = b.direction.at(i);
        const Real t = hit ? b.far[i] : 0;
        const vec3 reached = origin + t * direction;
        const vec3 center = time ? moved(record.center, record.velocity, b.time[i]) : record.center;
        const vec3 from_center = reached - center;
        const Real length = meet == Meet::flat ? 0 : std::sqrt(dot(from_center, from_center));
        const bool flat = meet == Meet::flat || record.radius == 0;
        const Real scale = flat ? 1 : 1 / length;
        const vec3 n{scale * (flat ? record.normal.x : from_center.x), scale * (flat ? record.normal.y : from_center.y),
                     scale * (flat ? record.normal.z : from_center.z)};
        // Back onto the surface: the distance that the ray came is no longer part of the error.
        const Real above = flat ? dot(from_center, n) : length - record.radius;
        const vec3 p = reached - above * n;
        const bool behind = dot(direction, n) > 0;
        const Real side = behind ? -1.0 : 1.0;
        s.point.set(i, p);
        s.flat.set(i, side * n);
        s.shading.set(i, side * n);
        s.error[i] = surface_error * (largest(p) + record.reach);
        s.material[i] = hit ? record.material : nothing;
        s.behind[i] = behind ? 1 : 0;
        s.shines[i] = hit && !behind ? record.shines : 0;
    }
}

void find_smooth_normals(const World& world, const Batch& b, Surfaces& s) {
    for (int i = 0; i < b.count; ++i) {
        if (s.material[i] == nothing) continue;
        const SurfaceRecord& record = world.surfaces[std::size_t(b.shape[i])];
        if (record.smooth == nothing) continue;
        const vec3 p = s.point.at(i) - (world.plan.time ? moved(vec3(0), record.velocity, b.time[i]) : vec3(0));
        const vec3 n = smooth_normal(world, b.shape[i], p);
        const vec3 side = s.behind[i] ? -n : n;
        const Material& m = world.scene.materials[std::size_t(s.material[i])];
        if (m.reflectance != Color(0) || m.transmittance != Color(0)) {
            const vec3 g = s.flat.at(i), d = b.direction.at(i);
            vec3 facing = bent(side, g, d);
            // Interpolated normals would catch light in glass for ever, hit after hit; that of the flat surface lets it
            // out.
            if (m.transmittance != Color(0) && is_totally_reflected(m, s.behind[i], dot(d, facing))) facing = g;
            s.shading.set(i, facing);
            continue;
        }
        // Seen from below, an interpolated normal would light what is turned away: there the flat one stands in.
        if (!(dot(side, b.direction.at(i)) < 0)) continue;
        s.shading.set(i, side);
    }
}

/// Whether a point is in one of the other squares of a checker, or cubes of them.
///
/// p  from where they begin
bool is_in_other_square(const World& world, Index shape, vec3 p, Real size) {
    const auto square = [size](Real x) { return std::floor(x / size); };
    if (shape >= world.first_quad && shape < world.first_disc) {
        const Quad& q = world.quads[std::size_t(shape - world.first_quad)];
        return std::fmod(square(dot(p, unit(q.u))) + square(dot(p, unit(q.v))), 2) != 0;
    }
    const Real half = size / 2;  // a plane through the middle of cubes is on the edge of none
    return std::fmod(square(p.x + half) + square(p.y + half) + square(p.z + half), 2) != 0;
}

void find_squares(const World& world, const Batch& b, Surfaces& s) {
    for (int i = 0; i < b.count; ++i) {
        if (s.material[i] == nothing) continue;
        const Index other = world.other_squares[std::size_t(s.material[i])];
        if (other == nothing) continue;
        const Index shape = b.shape[i];
        const vec3 begin = world.checker_origins[std::size_t(shape)];
        const vec3 velocity = world.surfaces[std::size_t(shape)].velocity;
        const vec3 p = s.point.at(i) - (world.plan.time ? moved(begin, velocity, b.time[i]) : begin);
        const Real size = world.scene.materials[std::size_t(other)].checker->size;
        if (is_in_other_square(world, shape, p, size)) s.material[i] = other;
    }
}

}  // namespace

void surface_stage(const World& world, const Batch& batch, Surfaces& surfaces) {
    if (world.surfaces.empty()) {
        for (int i = 0; i < lanes; ++i) surfaces.material[i] = nothing, surfaces.shines[i] = 0;
        return;
    }
    const Met met = met_by(batch.shape);
    with_flag(world.plan.time, [&](auto time) {
        if (!met.one) return find_surfaces<time(), Meet::any>(world, met.number, batch, surfaces);
        if (world.surfaces[std::size_t(met.number)].radius == 0)
            return find_surfaces<time(), Meet::flat>(world, met.number, batch, surfaces);
        find_surfaces<time(), Meet::one>(world, met.number, batch, surfaces);
    });
    if (world.plan.smooth) find_smooth_normals(world, batch, surfaces);
    if (world.plan.checker) find_squares(world, batch, surfaces);
}

}  // namespace rt
