#pragma once

#include <optional>

#include "rt/world.h"

/// The stages through which batches of rays flow. Each is a short loop over a batch that calls fragments for each lane.
///
///     camera → nearest → medium → emission → surface → direct → scatter → (nearest ...) → film
///
/// Why loops over lanes look as they do: see lanes.h.
namespace rt {

/// What paths carry that roulette never ends.
constexpr Real worth_following = 0.5;

/// The samples of some pixels, in the order of their slots.
struct CameraWork {
    const Real *x, *y;   // of the top left corner of the pixel of each lane [pixel]
    const Bits* keys;    // of the pixel of each lane
    const int* samples;  // index of each lane's sample
    int slot;            // of lane 0
    int count;           // lanes
    Pattern pattern;

    Extent pixel(int i) const { return {{x[i], y[i]}, {x[i] + 1, y[i] + 1}}; }
};

/// What all first rays have in common, and no stage changes: written once, for batch after batch.
void begin_camera(const World& world, Batch& batch);

/// Fills a batch with the first rays, and the samples' weights.
void camera_stage(const World& world, const CameraWork& work, Batch& batch, Chunk& chunk);

/// The numbers of lanes up to `count` in one dimension, from the keys of their paths and the indices of their samples.
void draw_2d(Pattern pattern, Dimension dimension, const Bits* keys, const int* samples, int count, Numbers& numbers);
void draw_1d(Pattern pattern, Dimension dimension, const Bits* keys, const int* samples, int count, Numbers& numbers);

/// A dimension of the pattern, by its place in the plan.
inline Dimension camera_dimension(const World& world, int dimension, int n) {
    return {Bits(dimension), world.plan.pairs[std::size_t(dimension)], n};
}

inline Dimension wave_dimension(const World& world, int wave, int dimension, int n) {
    const RenderPlan& plan = world.plan;
    return {plan.number(wave, dimension), plan.pairs[plan.place(dimension)] + wave * plan.pairs_of_wave, n};
}

/// What the later stages work on: a batch of rays, and what they have met.
struct Wave {
    const World& world;
    Pattern pattern;
    int number;  // 0: the camera's rays
    const Batch& batch;
    const Surfaces& surfaces;

    const Material& material(int i) const { return world.scene.materials[std::size_t(surfaces.material[i])]; }

    /// The numbers of lanes up to `count` in a dimension of the waves.
    void draw_2d(int dimension, int count, Numbers& u) const {
        rt::draw_2d(pattern, wave_dimension(world, number, dimension, pattern.n), batch.key, batch.sample, count, u);
    }
    void draw_1d(int dimension, int count, Numbers& u) const {
        rt::draw_1d(pattern, wave_dimension(world, number, dimension, pattern.n), batch.key, batch.sample, count, u);
    }
};

/// The digits of an orthogonal array of n samples, with which draws take a third of the time for lanes that have the
/// samples of a pixel in order, as the camera's do.
std::vector<LaneDigits> digits_of_lanes(int n);

/// Finds the nearest shape along each ray: its number and distance. Rays with far <= near meet nothing.
void nearest_stage(const World& world, Batch& batch);

/// Finds whether there is any shape along each ray: its number, or nothing.
void any_hit_stage(const World& world, Batch& batch);

/// Shadow rays that go through boundaries which bend no light: dims what they carry by the media and boundaries on
/// their way; where something else stops a ray, its number.
///
/// inside  the regions in which each lane starts
/// passed  none, or what each lane has passed
struct Passed {
    Real left = 1;       // the share of the light that the media alone leave
    int boundaries = 0;  // that were crossed

    /// The same for a path of this depth, which pays for each boundary: 0 where it cannot.
    Real by_path(int depth, int most) const { return depth + boundaries > most ? 0 : left; }
};
void through_stage(const World& world, const Bits* inside, Batch& shadow, Colors& light, Passed* passed = nullptr);

/// Share of the light that is left after a way through a medium.
inline Real left_by(const Medium& medium, Real distance) { return exp(-medium.extinction * distance); }

/// The same where there may be none.
inline Real left_around(const World& world, Bits inside, Real distance) {
    const Index medium = world.regions.medium(inside);
    return medium == nothing ? 1 : left_by(world.scene.materials[std::size_t(medium)].medium, distance);
}

/// Ends the lanes that are scattered inside a medium before they meet a surface; their new rays go to next. Adds the
/// light that is scattered straight from the lamps, as it arrives at the film. shadow is a scratch batch.
///
/// batch  the wave's
void medium_stage(const Wave& wave, Batch& batch, Batch& shadow, Queue& next, Colors& found, Chunk& chunk);

/// Points, normals and materials of the hits.
void surface_stage(const World& world, const Batch& batch, Surfaces& surfaces);

/// Adds the light that the rays' ends send out themselves, as it arrives at the film: emitters, the environment, the
/// background.
void emission_stage(const World& world, const Batch& batch, const Surfaces& surfaces, Colors& found);

/// The weight of a lamp that lane i has found, against the points of it that shadow rays have looked for; none where it
/// counts in full.
std::optional<Real> share_of_found(const World& world, const SurfaceRecord& lamp, const Batch& batch, int i);

/// Adds the light that the surfaces reflect straight from the lights, as it arrives at the film. shadow is a scratch
/// batch.
void direct_stage(const Wave& wave, Batch& shadow, Colors& found, Chunk& chunk);

/// Sends on the paths that mirrors, glass, lobes and diffuse surfaces continue; their new rays go to next.
void scatter_stage(const Wave& wave, Queue& next, Chunk& chunk);

/// The mean of one pixel's samples; or the sample, where there is one.
Color film_stage(const World& world, const Color* radiance, const Real* weight, int n);

/// What a path that carries this share of its light goes on with: more, or nothing. The mean stays.
///
/// u  random, 0 <= u < 1
inline Color after_roulette(Color weight, Real u) {
    const Real chance = largest(weight) / worth_following;
    return !(chance < 1) ? weight : u < chance ? weight * (1 / chance) : Color(0);  // nan goes on, and is told
}

/// How a path goes on: from a surface, but for the last.
enum class WayOn { mirror, glossy, glass, translucent, bounce, medium };

/// One direction, no lobe.
constexpr bool is_sharp(WayOn way) { return way == WayOn::mirror || way == WayOn::glass; }

/// To the other side of the surface.
constexpr bool leads_inside(WayOn way) { return way == WayOn::glass || way == WayOn::translucent; }

/// Whether a way on from a surface leads to the wrong side of it.
///
/// n  normal of the surface, on the side that the ray came from
inline bool is_astray(vec3 way_on, vec3 n, bool enters) { return enters ? dot(way_on, n) > 0 : dot(way_on, n) < 0; }

/// The same direction on the other side of a surface.
inline vec3 turned(vec3 direction, vec3 n) { return direction - 2 * dot(direction, n) * n; }

/// The greatest number of all lanes, at least 0, and whether every lane has it or a negative one.
struct Met {
    Index number;
    bool one;
};
inline Met met_by(const Index* numbers) {
    Index greatest = 0, differ = 0;
    for (int i = 0; i < lanes; ++i) greatest = numbers[i] > greatest ? numbers[i] : greatest;
    for (int i = 0; i < lanes; ++i) differ |= Index(numbers[i] >= 0) & Index(numbers[i] != greatest);
    return {greatest, differ == 0};
}

/// Calls f with a flag as a compile-time constant.
template <class F>
auto with_flag(bool flag, F f) {
    return flag ? f(std::true_type{}) : f(std::false_type{});
}

}  // namespace rt
