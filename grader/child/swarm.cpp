#include "protocol/swarm.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rt/fragments.h"
#include "rt/sampler.h"

namespace grade {

namespace {

using rt::Hit, rt::Ray, rt::Real, rt::vec3;

/// Random numbers of one call.
struct Draw {
    rt::Bits key, next = 0;

    Real unit() { return rt::to_unit(rt::combine(key, next++)); }
    Real between(Real low, Real high) { return low + unit() * (high - low); }
    vec3 box(Real half) {
        const Real x = between(-half, half), y = between(-half, half), z = between(-half, half);
        return {x, y, z};
    }
    vec3 direction() {
        const Real z = between(-1, 1);
        const rt::vec2 circle = rt::safe_sqrt(1 - z * z) * rt::unit_circle(unit());
        return {circle.x, circle.y, z};
    }
    /// From 2^-40 to 2^40, not only powers of two.
    Real size() { return std::exp2(between(-40, 40)); }
};

Draw draw(const SwarmRequest& request, rt::Bits number) {
    return {rt::combine(rt::combine(request.seed, rt::Bits(request.kind)), number)};
}

// ---- meshes ----

constexpr rt::Bits rays_of_a_mesh = 256;

struct Octahedron {
    Real size;
    std::array<rt::Triangle, 8> faces;
};

Octahedron octahedron(Draw d) {
    const Real size = d.size();
    const rt::Frame frame = rt::frame_about(d.direction());
    std::array<vec3, 6> corners;
    for (std::size_t i = 0; i < 6; ++i) {
        const vec3 axis = i < 2 ? frame.x : i < 4 ? frame.y : frame.z;
        const Real reach = d.between(0.7, 1.4);
        corners[i] = size * (reach * (i % 2 ? -axis : axis) + d.box(0.2));
    }
    Octahedron mesh{size, {}};
    for (std::size_t i = 0; i < 8; ++i)
        mesh.faces[i] = {corners[i & 1], corners[2 + (i >> 1 & 1)], corners[4 + (i >> 2)]};
    return mesh;
}

Real meets(const Octahedron& mesh, Draw d) {
    const vec3 origin = mesh.size * d.box(0.05);
    const rt::Triangle& face = mesh.faces[std::size_t(d.unit() * 8)];
    const Real how = d.unit(), along = d.unit();
    vec3 target = face.a;  // a corner
    if (how > 0.2) target += along * (face.b - face.a);
    vec3 way = rt::unit(target - origin);
    if (how > 0.5) way = d.direction();
    Real nearest = rt::inf;
    for (const rt::Triangle& each : mesh.faces)
        nearest = std::min(nearest, rt::hit_triangle(each, {origin, way, 0, rt::inf}));
    return nearest;
}

// ---- surfaces that are left ----

/// As the framework's surface stage has it: the point is put back onto the surface, of which it is so far above.
Hit hit_at(const Ray& ray, vec3 reached, Real above, vec3 outside, Real reach) {
    const vec3 p = reached - above * outside;
    const bool behind = dot(ray.direction, outside) > 0;
    return {p, behind ? -outside : outside, 32 * rt::roundoff * (rt::largest(p) + reach)};
}

/// A ray in the hemisphere about n.
vec3 away_from(vec3 n, Draw& d) {
    const vec3 way = d.direction();
    return dot(way, n) < 0 ? -way : way;
}

Real leaves_sphere(Draw d) {
    const Real size = d.size();
    const rt::Sphere sphere{size * d.box(2), size * d.between(0.2, 2)};
    const bool inside = d.unit() < 0.5;
    const vec3 way = d.direction(), target = sphere.center + 0.5 * sphere.radius * d.direction();
    const Ray ray{inside ? target : target - size * d.between(3, 6) * way, way, 0, rt::inf};
    const Real t = rt::hit_sphere(sphere, ray);
    if (!(t < rt::inf)) return NAN;
    const vec3 reached = ray.origin + t * way, round = reached - sphere.center;
    const Real length = std::sqrt(dot(round, round)), reach = rt::largest(sphere.center) + sphere.radius;
    const Hit hit = hit_at(ray, reached, length - sphere.radius, round / length, reach);
    const vec3 to = away_from(hit.normal, d);
    const Real again = rt::hit_sphere(sphere, rt::shadow_ray(hit, to, rt::inf));
    // from within, the far side is rightly met, a chord away
    return inside && again > sphere.radius * dot(to, hit.normal) ? rt::inf : again;
}

Real leaves_flat(Draw d, bool is_quad) {
    const Real size = d.size();
    const rt::Frame frame = rt::frame_about(d.direction());
    const vec3 center = size * d.box(2), u = size * d.between(0.2, 2) * frame.x, v = size * d.between(0.2, 2) * frame.y;
    const rt::Quad quad{center, u, v};
    const rt::Triangle triangle{center - u - v, center + u - v, center + v};
    const Real s = d.between(-0.4, 0.4), r = d.between(-0.4, 0);
    const vec3 way = d.direction(), target = center + s * u + r * v;
    const Ray ray{target - size * d.between(3, 6) * way, way, 0, rt::inf};
    const auto hit_by = [&](const Ray& some) {
        return is_quad ? rt::hit_quad(quad, some) : rt::hit_triangle(triangle, some);
    };
    // along the surface, a rounded ray may pass it by
    if (std::abs(dot(way, frame.z)) < 1e-9) return rt::inf;
    const Real t = hit_by(ray);
    if (!(t < rt::inf)) return NAN;
    const Real reach = std::max({rt::largest(center + u + v), rt::largest(center + u - v), rt::largest(center - u + v),
                                 rt::largest(center - u - v)});
    const vec3 normal =
        is_quad ? rt::unit(cross(u, v)) : rt::unit(cross(triangle.b - triangle.a, triangle.c - triangle.a));
    const vec3 reached = ray.origin + t * way;
    const Hit hit = hit_at(ray, reached, dot(reached - center, normal), normal, reach);
    const vec3 side = d.unit() < 0.5 ? hit.normal : -hit.normal;  // mirrored or let through
    return hit_by(rt::shadow_ray(hit, away_from(side, d), rt::inf));
}

}  // namespace

std::vector<double> swarm(const SwarmRequest& request) {
    std::vector<double> answers;
    answers.reserve(request.count);
    Octahedron mesh{};
    for (rt::Bits i = request.first; i < request.first + request.count; ++i) {
        if (request.kind == Swarm::mesh && (i == request.first || i % rays_of_a_mesh == 0))
            mesh = octahedron(draw(request, ~(i / rays_of_a_mesh)));
        const Draw d = draw(request, i);
        switch (request.kind) {
            case Swarm::mesh:
                answers.push_back(meets(mesh, d));
                break;
            case Swarm::leave_sphere:
                answers.push_back(leaves_sphere(d));
                break;
            case Swarm::leave_quad:
                answers.push_back(leaves_flat(d, true));
                break;
            case Swarm::leave_triangle:
                answers.push_back(leaves_flat(d, false));
                break;
        }
    }
    return answers;
}

}  // namespace grade
