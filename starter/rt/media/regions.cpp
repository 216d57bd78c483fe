#include "rt/media/regions.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "rt/world.h"

namespace rt {
namespace {

/// How near to a boundary a point is on it, in its distance from the origin.
constexpr Real on_boundary = 0x1p-46;

/// The solid angle of a triangle, seen from the origin [sr]; negative from its front.
///
/// Source: van Oosterom and Strackee, "The Solid Angle of a Plane Triangle", IEEE Trans. Biomed. Eng. 30(2), 1983.
Real solid_angle(vec3 a, vec3 b, vec3 c) {
    const Real x = length(a), y = length(b), z = length(c);
    return 2 * std::atan2(dot(a, exact_cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
}

/// Calls f with triangles that together are the shape; discs become polygons.
template <class F>
void with_triangles(const World& world, Index shape, F f) {
    if (shape < world.first_quad) {
        const Triangle& t = world.triangles[std::size_t(shape - world.first_triangle)];
        f(t.a, t.b, t.c);
    } else if (shape < world.first_disc) {
        const Quad& q = world.quads[std::size_t(shape - world.first_quad)];
        const vec3 a = q.center - q.u - q.v, b = q.center + q.u - q.v, c = q.center + q.u + q.v,
                   d = q.center - q.u + q.v;
        f(a, b, c), f(a, c, d);
    } else {
        const Disc& disc = world.discs[std::size_t(shape - world.first_disc)];
        const Frame frame = frame_about(disc.normal);
        constexpr int corners = 64;
        const auto corner = [&](int i) {
            const vec2 at = unit_circle(Real(i % corners) / corners);
            return disc.center + disc.radius * (at.x * frame.x + at.y * frame.y);
        };
        for (int i = 0; i < corners; ++i) f(disc.center, corner(i), corner(i + 1));
    }
}

/// Whether every edge of a mesh is met by as many triangles one way as the other; vertices count by their places.
bool is_closed(const Mesh& mesh) {
    const auto less = [](vec3 a, vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    std::map<vec3, int, decltype(less)> places(less);
    std::vector<int> place;
    for (const vec3& v : mesh.vertices) place.push_back(places.try_emplace(v, int(places.size())).first->second);
    std::vector<std::array<int, 3>> edges;
    for (const glm::ivec3 t : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const int a = place[std::size_t(t[i])], b = place[std::size_t(t[(i + 1) % 3])];
            if (a != b) edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
        }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();) {
        int sum = 0;
        const auto edge = edges[i];
        for (; i < edges.size() && edges[i][0] == edge[0] && edges[i][1] == edge[1]; ++i) sum += edges[i][2];
        if (sum != 0) return false;
    }
    return true;
}

/// Whether flat shapes enclose nothing: they all face one way, more or less.
bool is_sheet(const World& world, const Region& region) {
    vec3 sum(0);
    Real whole = 0;
    for (const Index shape : region.shapes) {
        if (shape < world.first_triangle) return false;
        with_triangles(world, shape, [&](vec3 a, vec3 b, vec3 c) {
            const vec3 area = cross(b - a, c - a);
            sum += area, whole += length(area);
        });
    }
    return length(sum) > 0.5 * whole;
}

/// The distance of a point from a box.
Real distance_to(const Box& box, vec3 p) {
    const vec3 apart = glm::max(glm::max(box.low - p, p - box.high), vec3(0));
    return length(apart);
}

/// Whether the boundary may come as near to a point as this.
bool may_be_near(const World& world, const Region& region, vec3 p, Real reach) {
    if (region.moves) return distance_to(region.box, p) <= reach;
    for (const Index shape : region.shapes) {
        if (shape < world.first_triangle) {
            const Sphere& s = world.spheres[std::size_t(shape)];
            if (std::abs(length(p - s.center) - s.radius) <= reach) return true;
            continue;
        }
        const SurfaceRecord& record = world.surfaces[std::size_t(shape)];
        if (std::abs(dot(p - record.center, record.normal)) > reach) continue;
        Box box;
        with_triangles(world, shape, [&](vec3 a, vec3 b, vec3 c) { box.include(a), box.include(b), box.include(c); });
        if (distance_to(box, p) <= reach) return true;
    }
    return false;
}

/// How far a point is that counts as on the boundary: roundings of the largest number that takes part.
Real thickness(const Region& region, vec3 p) {
    return on_boundary * (largest(p) + std::max(largest(region.box.low), largest(region.box.high)));
}

/// Collects the shapes that let light in, region by region.
std::vector<Region> collect(const Scene& scene, const World& world) {
    std::vector<Region> regions;
    std::map<Index, std::size_t> of_material;
    const auto lets_light_in = [&](Index material) {
        return scene.materials[std::size_t(material)].transmittance != Color(0);
    };
    const auto start = [&](Index material) {
        regions.push_back({material, {}, {}, false});
        return regions.size() - 1;
    };
    const auto together = [&](Index material) {
        const auto [place, fresh] = of_material.try_emplace(material, regions.size());
        return fresh ? start(material) : place->second;
    };
    const auto put = [&](std::size_t region, Index shape) { regions[region].shapes.push_back(shape); };
    Index meshed = world.first_quad;
    for (const Mesh& mesh : scene.meshes) meshed -= Index(mesh.triangles.size());
    const Index all = Index(world.surfaces.size());
    for (Index shape = 0; shape < all; ++shape) {
        if (shape == meshed) shape = world.first_quad;  // meshes follow below
        if (shape == all) break;
        const Index material = world.surfaces[std::size_t(shape)].material;
        if (lets_light_in(material)) put(shape < world.first_triangle ? start(material) : together(material), shape);
    }
    for (const Mesh& mesh : scene.meshes) {
        const Index first = meshed;
        meshed += Index(mesh.triangles.size());
        if (!lets_light_in(mesh.material) || mesh.triangles.empty()) continue;
        const std::size_t region = is_closed(mesh) ? start(mesh.material) : together(mesh.material);
        for (Index shape = first; shape < meshed; ++shape) put(region, shape);
    }
    return regions;
}

}  // namespace

bool is_inside(const World& world, const Region& region, vec3 p, Real time) {
    if (distance_to(region.box, p) > 0) return false;
    Real turns = 0;
    for (const Index shape : region.shapes) {
        const SurfaceRecord& record = world.surfaces[std::size_t(shape)];
        const vec3 q = p - time * record.velocity;
        if (shape < world.first_triangle) {
            const Sphere& s = world.spheres[std::size_t(shape)];
            return dot(q - s.center, q - s.center) < sqr(s.radius);
        }
        with_triangles(world, shape, [&](vec3 a, vec3 b, vec3 c) { turns += solid_angle(a - q, b - q, c - q); });
    }
    return turns > 2 * pi * (1 + 1e-9);  // from inside, a closed boundary fills the full solid angle of 4 pi
}

Bits regions_around(const World& world, vec3 p, Real time) {
    const Regions& regions = world.regions;
    Bits inside = 0;
    for (std::size_t i = 0; i < regions.all.size(); ++i)
        if (is_inside(world, regions.all[i], p, time)) inside = entered(inside, i + 1, regions.bits);
    return inside;
}

Bits start_of(const World& world, Ray& ray, Real time) {
    const Regions& regions = world.regions;
    Bits inside = regions.start;
    for (const Bits number : regions.asked) {
        const Region& region = regions.all[number - 1];
        const Real beyond = thickness(region, ray.origin);
        ray.near = std::max(ray.near, beyond);
        if (is_inside(world, region, ray.origin + beyond * ray.direction, time))
            inside = entered(inside, number, regions.bits);
    }
    return inside;
}

Regions find_regions(const Scene& scene, const World& world) {
    Regions regions;
    if (!world.plan.medium) return regions;
    regions.all = collect(scene, world);
    for (Region& region : regions.all)
        for (const Index shape : region.shapes) {
            const vec3 velocity = world.surfaces[std::size_t(shape)].velocity;
            region.moves |= velocity != vec3(0);
            Box box;
            if (shape < world.first_triangle) {
                const Sphere& s = world.spheres[std::size_t(shape)];
                box = {s.center - s.radius, s.center + s.radius};
            } else {
                with_triangles(world, shape,
                               [&](vec3 a, vec3 b, vec3 c) { box.include(a), box.include(b), box.include(c); });
            }
            for (const Real time : {scene.shutter.open, scene.shutter.close})
                region.box.include(Box{box.low + time * velocity, box.high + time * velocity});
        }
    // A pane without a medium is thin: what is behind it is what is before it.
    std::erase_if(regions.all, [&](const Region& region) {
        return scene.materials[std::size_t(region.material)].medium.extinction == 0 && is_sheet(world, region);
    });
    const auto size = [](const Region& region) {
        const vec3 edges = region.box.high - region.box.low;
        return edges.x * edges.y * edges.z;
    };
    std::stable_sort(regions.all.begin(), regions.all.end(),
                     [&](const Region& a, const Region& b) { return size(a) > size(b); });

    regions.bits = nesting_bits(regions.all.size());
    regions.of_shape.assign(world.surfaces.size(), 0);
    regions.filled_with = {nothing};
    for (std::size_t i = 0; i < regions.all.size(); ++i) {
        const Region& region = regions.all[i];
        for (const Index shape : region.shapes) regions.of_shape[std::size_t(shape)] = i + 1;
        const bool clear = scene.materials[std::size_t(region.material)].medium.extinction == 0;
        regions.filled_with.push_back(clear ? nothing : region.material);
        const vec3 eye = scene.camera.eye;
        if (may_be_near(world, region, eye, scene.camera.lens_radius * (1 + 1e-6) + thickness(region, eye)))
            regions.asked.push_back(i + 1);
        else if (is_inside(world, region, eye, scene.shutter.open))
            regions.start = entered(regions.start, i + 1, regions.bits);
    }
    return regions;
}

}  // namespace rt
