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

/// Where the squares or cubes of a checker begin.
vec3 checker_origin(const Sphere& s, vec3) { return s.center; }
vec3 checker_origin(const Triangle&, vec3 shift) { return shift; }
vec3 checker_origin(const Quad& q, vec3) { return q.center; }
vec3 checker_origin(const Disc& d, vec3) { return d.center; }

/// Puts shapes in the lists and the table, kind by kind.
struct Layout {
    World world;

    /// A shape that does not move while the shutter is open is put where it is then.
    template <class S>
    void add(LargeVector<S>& list, S shape, int material, vec3 velocity, Index smooth = nothing) {
        vec3 shift(0);
        if (!world.plan.time) {
            shift = world.scene.shutter.open * velocity;
            shape = at(shape, shift);
            velocity = vec3(0);
        }
        if (world.plan.checker) world.checker_origins.push_back(checker_origin(shape, shift));
        const Box box = swept(shape, velocity, world.scene.shutter);
        SurfaceRecord r = record(shape);
        r.reach = std::max(largest(box.low), largest(box.high));
        r.velocity = velocity;
        r.material = material;
        r.shines = world.scene.materials[std::size_t(material)].emission != Color(0);
        r.smooth = smooth;
        list.push_back(shape);
        world.surfaces.push_back(r);
    }

    template <class S>
    void add_kind(const Scene& scene, LargeVector<S>& list) {
        for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
            const Shape& shape = scene.shapes[i];
            const S* s = std::get_if<S>(&shape.geometry);
            if (!s) continue;
            add(list, *s, shape.material, shape.velocity);
            if constexpr (!std::is_same_v<S, Triangle>)
                if (std::binary_search(world.plan.lamps.begin(), world.plan.lamps.end(), int(i)))
                    add_emitter(emitter(list.back(), world.scene.materials[std::size_t(shape.material)].emission));
        }
    }

    /// The shape that was added last shines, and shadow rays look for it.
    void add_emitter(const Emitter& light) {
        SurfaceRecord& r = world.surfaces.back();
        r.emitter = Index(world.emitters.size());
        r.area = area(light);
        world.emitters.push_back(light);
    }

    void add_mesh(const Mesh& mesh) {
        const int first = int(world.normals.size());
        world.normals.insert(world.normals.end(), mesh.normals.begin(), mesh.normals.end());
        for (const glm::ivec3 c : mesh.triangles) {
            Index smooth = nothing;
            if (!mesh.normals.empty()) {
                smooth = Index(world.corners.size());
                world.corners.push_back(c + first);
            }
            add(world.triangles, {mesh.vertices[c.x], mesh.vertices[c.y], mesh.vertices[c.z]}, mesh.material,
                mesh.velocity, smooth);
        }
    }

    /// All that a shape fills while the shutter is open.
    template <class S>
    static Box swept(const S& shape, vec3 velocity, const Shutter& shutter) {
        Box box = bounds(at(shape, shutter.open * velocity));
        box.include(bounds(at(shape, shutter.close * velocity)));
        return box;
    }

    /// The box of a shape, by its number.
    Box box_of(std::size_t id) const {
        const auto in = [&](const auto& list, Index first) {
            return swept(list[id - std::size_t(first)], world.surfaces[id].velocity, world.scene.shutter);
        };
        Box box = Index(id) < world.first_triangle ? in(world.spheres, 0)
                  : Index(id) < world.first_quad   ? in(world.triangles, world.first_triangle)
                  : Index(id) < world.first_disc   ? in(world.quads, world.first_quad)
                                                   : in(world.discs, world.first_disc);
        // A rounding error must not push a shape out of its box, nor may a flat box have no inside.
        const Real margin = 8 * roundoff * world.surfaces[id].reach;
        box.low -= margin, box.high += margin;
        return box;
    }
};

/// A checker is two materials, of which the surface stage takes one.
void add_other_squares(World& world) {
    std::vector<Material>& materials = world.scene.materials;
    world.other_squares.assign(materials.size(), nothing);
    for (std::size_t i = 0; i < world.other_squares.size(); ++i) {
        if (!materials[i].checker) continue;
        Material other = materials[i];
        other.albedo = other.checker->albedo;
        world.other_squares[i] = Index(materials.size());
        materials.push_back(other);
    }
}

/// How many shapes there are, so that the lists need not grow.
void reserve(World& world, const Scene& scene) {
    std::size_t triangles = 0, smooth = 0;
    for (const Mesh& mesh : scene.meshes) {
        triangles += mesh.triangles.size();
        if (!mesh.normals.empty()) smooth += mesh.triangles.size();
    }
    for (const Shape& shape : scene.shapes) triangles += std::holds_alternative<Triangle>(shape.geometry);
    world.triangles.reserve(triangles);
    world.corners.reserve(smooth);
    world.surfaces.reserve(triangles + scene.shapes.size());
}

}  // namespace

World make_world(const Scene& scene, const Sampling& sampling) {
    Layout layout{{.scene = scene, .plan = make_plan(scene, sampling)}};
    World& world = layout.world;
    if (world.plan.checker) add_other_squares(world);
    world.reflectances.push_back({});
    for (const Material& m : world.scene.materials)
        world.reflectances.push_back(
            {m.albedo, m.specular, m.shininess, Index(m.albedo != Color(0) || m.specular != Color(0)),
             Index(m.exponent < inf && (m.reflectance != Color(0) || m.transmittance != Color(0)))});
    world.scene.shapes = {};
    world.scene.meshes = {};
    reserve(world, scene);
    layout.add_kind(scene, world.spheres);
    world.first_triangle = Index(world.surfaces.size());
    layout.add_kind(scene, world.triangles);
    for (const Mesh& mesh : scene.meshes) layout.add_mesh(mesh);
    world.first_quad = Index(world.surfaces.size());
    layout.add_kind(scene, world.quads);
    world.first_disc = Index(world.surfaces.size());
    layout.add_kind(scene, world.discs);
    if (world.plan.one_lamp) world.lamp_tree = LampTree(world.emitters);
    if (world.plan.bvh) world.bvh = build_bvh(world.surfaces.size(), [&](std::size_t id) { return layout.box_of(id); });
    constexpr std::size_t most = 1 << 16;  // nodes: of a million triangles, corners take memory and win next to nothing
    if (world.plan.bvh && world.plan.triangles && !world.plan.time && world.bvh.nodes.size() <= most)
        add_corners(world.bvh, [&](std::size_t id) {
            const std::size_t k = id - std::size_t(world.first_triangle);
            return k < world.triangles.size() ? &world.triangles[k] : nullptr;
        });
    if (!world.plan.bvh)
        for (std::size_t id = 0; id < world.surfaces.size(); ++id) world.boxes.push_back(layout.box_of(id));
    world.regions = find_regions(scene, world);
    return std::move(layout.world);
}

}  // namespace rt
