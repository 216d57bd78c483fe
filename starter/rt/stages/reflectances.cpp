#include "rt/stages/reflectances.h"

#include "rt/stages/scatter.h"

namespace rt {
namespace {

[[gnu::noinline]] bool look_up_each(const World& world, int count, const Surfaces& s, Reflectances& r) {
    const Reflectance* table = world.reflectances.data();
    const Index last = count;
    Index any = 0;
    for (Index i = 0; i < lanes; ++i) {
        const Reflectance& m = table[i < last ? s.material[i] + 1 : 0];
        any |= m.reflects;
        r.albedo.set(int(i), m.albedo);
    }
    if (!world.plan.phong) return any != 0;
    for (Index i = 0; i < lanes; ++i) {
        const Reflectance& m = table[i < last ? s.material[i] + 1 : 0];
        r.specular.set(int(i), m.specular);
        r.shininess[i] = m.shininess;
    }
    return any != 0;
}

/// Where all lanes that are on a surface have one material.
[[gnu::noinline]] bool spread(const Reflectance& in_memory, bool phong, int count, const Surfaces& s, Reflectances& r) {
    const Reflectance m = in_memory;
    const Index last = count;
    Index any = 0;
    for (Index i = 0; i < lanes; ++i) {
        const bool on = bool(i < last) & bool(s.material[i] >= 0);
        any |= on;
        r.albedo.set(int(i), {on ? m.albedo.x : 0, on ? m.albedo.y : 0, on ? m.albedo.z : 0});
    }
    for (Index i = 0; phong && i < lanes; ++i) {
        const bool on = bool(i < last) & bool(s.material[i] >= 0);
        r.specular.set(int(i), {on ? m.specular.x : 0, on ? m.specular.y : 0, on ? m.specular.z : 0});
        r.shininess[i] = m.shininess;
    }
    return m.reflects != 0 && any != 0;
}

}  // namespace

bool look_up_reflectances(const World& world, int count, const Surfaces& s, Reflectances& r) {
    const auto [material, one] = met_by(s.material);
    if (!one || world.scene.materials.empty()) return look_up_each(world, count, s, r);
    return spread(world.reflectances[std::size_t(material) + 1], world.plan.phong, count, s, r);
}

bool look_up_lobes(const World& world, const Batch& b, const Surfaces& s, Lobes& lobes) {
    if (!world.plan.weigh) return false;
    const Reflectance* table = world.reflectances.data();
    const Index last = b.count, depth = world.scene.depth;
    Index lobe[lanes], any = 0;
    for (Index i = 0; i < lanes; ++i) {
        lobe[i] = table[i < last ? s.material[i] + 1 : 0].lobe & (b.depth[i] < depth);
        any |= lobe[i];
    }
    if (!any) return false;
    lobes = {};
    for (int i = 0; i < b.count; ++i) {
        if (!lobe[i]) continue;
        const Material& m = world.scene.materials[std::size_t(s.material[i])];
        lobes.mirror.set(i, outgoing(m, b, s, i).mirror);
        lobes.exponent[i] = m.exponent;
    }
    return true;
}

}  // namespace rt
