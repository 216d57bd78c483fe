#include "rt/stages/stages.h"

namespace rt {
namespace {

/// Whether a ray leaves a shape that it meets, and does not enter it.
bool comes_from_behind(const World& world, Index shape, const Ray& ray, Real t, Real time) {
    const SurfaceRecord& record = world.surfaces[std::size_t(shape)];
    if (record.radius == 0) return dot(ray.direction, record.normal) > 0;
    return dot(ray.direction, ray.origin + t * ray.direction - record.center - time * record.velocity) > 0;
}

}  // namespace

void through_stage(const World& world, const Bits* starts, Batch& shadow, Colors& light, Passed* passed) {
    const Regions& regions = world.regions;
    Real whole[lanes];
    Bits inside[lanes];
    for (int i = 0; i < shadow.count; ++i) {
        whole[i] = shadow.far[i];
        inside[i] = starts[i];
        shadow.shape[i] = nothing;
    }
    for (int under_way = shadow.count; under_way > 0;) {
        nearest_stage(world, shadow);
        under_way = 0;
        for (int i = 0; i < shadow.count; ++i) {
            if (!(shadow.near[i] < shadow.far[i])) continue;
            const Index shape = shadow.shape[i];
            const Index medium = world.plan.medium ? regions.medium(inside[i]) : nothing;
            const Real t = shadow.far[i], way = t - shadow.near[i];
            if (medium != nothing) {
                const Real share = left_by(world.scene.materials[std::size_t(medium)].medium, way);
                light.set(i, share * light.at(i));
                if (passed) passed[i].left *= share;
            }
            shadow.near[i] = t;  // no interval is left
            if (shape == nothing) continue;
            const Material& m = world.scene.materials[std::size_t(world.surfaces[std::size_t(shape)].material)];
            if (!goes_straight_through(m)) continue;
            if (world.plan.medium) {
                const bool behind = comes_from_behind(world, shape, shadow.ray(i), t, shadow.time[i]);
                inside[i] = regions.crossed(inside[i], shape, behind);
            }
            if (passed) ++passed[i].boundaries;
            light.set(i, m.transmittance * light.at(i));
            shadow.far[i] = whole[i], shadow.shape[i] = nothing;
            ++under_way;
        }
    }
}

}  // namespace rt
