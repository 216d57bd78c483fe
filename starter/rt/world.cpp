#include "rt/world.h"

namespace rt {
namespace {

Box bounds(const Sphere& s) { return {s.center - s.radius, s.center + s.radius}; }

Box bounds(const Triangle& t) {
    Box box;
    box.include(t.a), box.include(t.b), box.include(t.c);
    return box;
}

Box bounds(const Quad& q) {
    const vec3 half = glm::abs(q.u) + glm::abs(q.v);
    return {q.center - half, q.center + half};
}

Box bounds(const Disc& d) {
    const vec3 n = d.normal;
    const vec3 half = d.radius * vec3(safe_sqrt(1 - n.x * n.x), safe_sqrt(1 - n.y * n.y), safe_sqrt(1 - n.z * n.z));
    return {d.center - half, d.center + half};
}

Sphere at(Sphere s, vec3 shift) { return {s.center + shift, s.radius}; }
Triangle at(Triangle t, vec3 shift) { return {t.a + shift, t.b + shift, t.c + shift}; }
Quad at(Quad q, vec3 shift) { return {q.center + shift, q.u, q.v}; }
Disc at(Disc d, vec3 shift) { return {d.center + shift, d.normal, d.radius}; }

SurfaceRecord record(const Sphere& s) { return {.center = s.center, .radius = s.radius}; }
SurfaceRecord record(const Triangle& t) { return {.center = t.a, .normal = unit(exact_cross(t.b - t.a, t.c - t.a))}; }
SurfaceRecord record(const Quad& q) { return {.center = q.center, .normal = unit(cross(q.u, q.v))}; }
SurfaceRecord record(const Disc& d) { return {.center = d.center, .normal = d.normal}; }

Emitter emitter(const Sphere& s) { return {Emitter::Kind::sphere, {}, {}, s, {}}; }
Emitter emitter(const Quad& q) { return {Emitter::Kind::quad, q, {}, {}, {}}; }
Emitter emitter(const Disc& d) { return {Emitter::Kind::disc, {}, d, {}, {}}; }

/// Puts shapes in the lists, the tree and the table, kind by kind.
struct Layout {
    World world;
    std::vector<Box> boxes;

    /// A shape that does not move while the shutter is open is put where it is then.
    template <class S>
    void add(std::vector<Numbered<S>>& list, S shape, int material, vec3 velocity, Index smooth = nothing) {
        const Shutter& shutter = world.scene.shutter;
        if (!world.plan.time) {
            shape = at(shape, shutter.open * velocity);
            velocity = vec3(0);
        }
        Box box = bounds(at(shape, shutter.open * velocity));
        box.include(bounds(at(shape, shutter.close * velocity)));
        // A rounding error must not push a shape out of its box, nor may a flat box have no inside.
        const Real reach = std::max(largest(box.low), largest(box.high));
        const Real margin = 8 * roundoff * reach;
        box.low -= margin, box.high += margin;

        const Material& m = world.scene.materials[std::size_t(material)];
        SurfaceRecord r = record(shape);
        r.reach = reach;
        r.velocity = velocity;
        r.material = material;
        r.shines = m.emission != Color(0);
        r.smooth = smooth;
        if constexpr (!std::is_same_v<S, Triangle>) {
            if (m.emission != Color(0) && m.sampled && velocity == vec3(0)) {
                r.sampled = true;
                world.emitters.push_back(emitter(shape));
                world.emitters.back().radiance = m.emission;
            }
        }
        list.push_back({shape, Index(world.surfaces.size()), velocity, box});
        world.surfaces.push_back(r);
        if (world.plan.bvh) boxes.push_back(box);
    }

    template <class S>
    void add_kind(std::vector<Numbered<S>>& list) {
        for (const Shape& shape : world.scene.shapes)
            if (const S* s = std::get_if<S>(&shape.geometry)) add(list, *s, shape.material, shape.velocity);
    }

    void add_mesh(const Mesh& mesh) {
        for (const glm::ivec3 c : mesh.triangles) {
            const Triangle t{mesh.vertices[c.x], mesh.vertices[c.y], mesh.vertices[c.z]};
            Index smooth = nothing;
            if (!mesh.normals.empty()) {
                smooth = Index(world.smooth.size());
                world.smooth.push_back({t, mesh.normals[c.x], mesh.normals[c.y], mesh.normals[c.z]});
            }
            add(world.triangles, t, mesh.material, mesh.velocity, smooth);
        }
    }
};

}  // namespace

World make_world(const Scene& scene) {
    Layout layout{{.scene = scene, .plan = make_plan(scene)}, {}};
    World& world = layout.world;
    world.reflectances.push_back({});
    for (const Material& m : scene.materials)
        world.reflectances.push_back(
            {m.albedo, m.specular, m.shininess, Index(m.albedo != Color(0) || m.specular != Color(0))});
    layout.add_kind(world.spheres);
    layout.add_kind(world.triangles);
    for (const Mesh& mesh : scene.meshes) layout.add_mesh(mesh);
    layout.add_kind(world.quads);
    layout.add_kind(world.discs);
    world.scene.shapes.clear();
    world.scene.meshes.clear();
    if (world.plan.bvh) world.bvh = build_bvh(layout.boxes);
    return std::move(layout.world);
}

}  // namespace rt
