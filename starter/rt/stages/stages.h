#pragma once

#include "rt/world.h"

/// The stages through which batches of rays flow. Each is a short loop over a batch that calls fragments for each lane.
///
///     camera → nearest → medium → emission → surface → direct → scatter → (nearest ...) → film
///
/// Lanes of one batch do not depend on each other: a loop marked with ivdep may run in any order, hence vectorised.
namespace rt {

/// The samples of some pixels, in the order of their slots.
struct CameraWork {
    const Extent* extents;  // of the pixel of each lane
    const Bits* keys;       // of the pixel of each lane
    const int* samples;     // index of each lane's sample
    int slot;               // of lane 0
    int count;              // lanes
    Pattern pattern;
};

/// Fills a batch with the first rays, and the samples' weights.
void camera_stage(const World& world, const CameraWork& work, Batch& batch, Chunk& chunk);

/// The numbers of lanes up to `count` in one dimension, from the keys of their paths and the indices of their samples.
void draw_2d(Pattern pattern, Dimension dimension, const Bits* keys, const int* samples, int count, Numbers& numbers);
void draw_1d(Pattern pattern, Dimension dimension, const Bits* keys, const int* samples, int count, Numbers& numbers);

/// Finds the nearest shape along each ray: its number and distance. Rays with far <= near meet nothing.
void nearest_stage(const World& world, Batch& batch);

/// Finds whether there is any shape along each ray: its number, or nothing.
void any_hit_stage(const World& world, Batch& batch);

/// Ends the lanes that are scattered inside a medium before they meet a surface; their new rays go to next.
void medium_stage(const World& world, Pattern pattern, int wave, Batch& batch, Queue& next, Chunk& chunk);

/// Points, normals and materials of the hits.
void surface_stage(const World& world, const Batch& batch, Surfaces& surfaces);

/// Adds the light that the rays' ends send out themselves, as it arrives at the film: emitters, the environment, the
/// background.
void emission_stage(const World& world, const Batch& batch, const Surfaces& surfaces, Colors& found);

/// Adds the light that the surfaces reflect straight from the lights, as it arrives at the film. shadow is a scratch
/// batch.
void direct_stage(const World& world, Pattern pattern, int wave, const Batch& batch, const Surfaces& surfaces,
                  Batch& shadow, Colors& found, Chunk& chunk);

/// Sends on the paths that mirrors, glass, lobes and diffuse surfaces continue; their new rays go to next.
void scatter_stage(const World& world, Pattern pattern, int wave, const Batch& batch, const Surfaces& surfaces,
                   Queue& next, Chunk& chunk);

/// The mean of one pixel's samples; or the sample, where there is one.
Color film_stage(const World& world, const Color* radiance, const Real* weight, int n);

/// What leaves the surface of lane i towards the viewer, and with which weights.
inline Outgoing outgoing(const Material& m, const Batch& b, const Surfaces& s, int i) {
    Real fresnel = 0;
    if (m.transmittance != Color(0)) {
        const Real cosine = -dot(vec3(b.dx[i], b.dy[i], b.dz[i]), s.normal(i));
        fresnel = s.behind[i] ? fresnel_dielectric(cosine, m.ior, 1) : fresnel_dielectric(cosine, 1, m.ior);
    }
    return whitted(m, fresnel);
}

/// Calls f with a flag as a compile-time constant.
template <class F>
auto with_flag(bool flag, F f) {
    return flag ? f(std::true_type{}) : f(std::false_type{});
}

/// A dimension of the pattern, by its place in the plan.
inline Dimension camera_dimension(const World& world, int dimension, int n) {
    return {Bits(dimension), world.plan.pairs[std::size_t(dimension)], n};
}

inline Dimension wave_dimension(const World& world, int wave, int dimension, int n) {
    const RenderPlan& plan = world.plan;
    return {Bits(plan.camera_dimensions + wave * plan.wave_dimensions + dimension),
            plan.pairs[std::size_t(plan.camera_dimensions + dimension)] + wave * plan.pairs_of_wave, n};
}

}  // namespace rt
