#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rt/lamps/ways.h"
#include "rt/scene.h"

namespace rt {

/// The pattern's dimensions: first those of the camera, then as many for each wave. A new one is named below zero, -1,
/// -2, ..., where its number is nobody else's: so no random number of the others changes, and no picture.
enum CameraDimension : int { pixel_dimension, lens_dimension, time_dimension, camera_dimensions };
enum WaveDimension : int {
    choice_dimension = 0,
    lobe_dimension,
    flight_dimension,
    phase_dimension,
    environment_dimension,
    light_dimension  // and those of further lamps
};
constexpr int roulette_dimension = -1;
constexpr int most_new_dimensions = 16;

/// How the pixels of a picture are sampled.
struct Sampling {
    int samples = 1;      // a pixel, in one pass
    bool passes = false;  // more passes may follow
    Sampler sampler = Sampler::orthogonal;
    bool one_of_many = false;  // the mean of pictures with other seeds is what counts
};

/// Whether shadow rays look for a shape. They do for what shines, unless its material says otherwise; but they can only
/// aim at quads, discs and spheres that stand still.
enum class Aim { not_asked, possible, impossible };
Aim aim_at(const Shape& shape, const Material& material);

/// The numbers of the materials that are on anything.
std::vector<int> materials_in_use(const Scene& scene);

/// As the scene says.
inline Sampling sampling_of(const Scene& scene) { return {scene.samples, false, scene.sampler}; }

/// What lamps would light, if they are sampled.
struct LitByLamps {
    bool surfaces = false, lobes = false, media = false;
};

/// What a scene needs, decided before the first ray; nothing else decides. An integral that is off draws no random
/// number, casts no ray and has no dimension in the sampling pattern.
struct RenderPlan {
    // the integrals
    bool pixel = false;  // more than one sample a pixel, in all; else the ray goes through its centre, without a mean
    bool light = false;  // emitters with extent are sampled
    bool lobe = false;   // glossy or translucent surfaces
    bool lens = false;
    bool time = false;    // something moves while the shutter is open
    bool bounce = false;  // diffuse bounces
    bool medium = false;

    // what is traced
    bool point_lights = false, environment = false, emission = false;
    bool specular = false;  // mirrors or glass: more than one wave of rays
    bool split = false;     // mirror and glass rays are both followed, as Whitted does, to depth 24; else one is chosen
    bool choice = false;    // a surface has several ways on, and one is chosen at random
    bool phong = false;     // a highlight
    bool weigh = false;     // lamps are sampled for glossy lobes too: multiple importance sampling
    bool solid_angle = false;      // quads that shine are sampled by solid angle
    bool one_lamp = false;         // one of many lamps is chosen at each point
    bool environment_lit = false;  // diffuse surfaces gather light from the environment
    bool sky_by_bounces = false;   // diffuse rays bring it; shadow rays look for it where none goes on
    bool bvh = false;
    bool spheres = false, triangles = false, quads = false, discs = false;
    bool smooth = false;        // meshes with normals
    bool checker = false;       // an albedo in every other square
    bool media_lit = false;     // lamps are sampled where a medium scatters, and weighed against its phase function
    bool roulette = false;      // paths that carry little end at random
    bool through = false;       // shadow rays go through boundaries that bend no light
    bool counts_twice = false;  // a diffuse ray may find what shadow rays have gathered; else all that is seen counts

    // which surfaces there are; no stage asks
    bool diffuse = false, ambient = false;
    bool mirrors = false, glass = false, glossy = false, translucent = false;  // and the depth of paths allows for them

    LitByLamps lit;
    bool quad_lamps = false;  // some that are sampled are quads
    std::vector<int> lamps;   // the shapes that shadow rays look for, by their places in the scene
    LampWays ways;            // why they are sampled so
    std::string ends_early;   // why paths that carry little end at random, or why not

    // the dimensions of one sample: where each integral's random numbers start
    int camera_dimensions = 0;  // pixel, lens, time
    int wave_dimensions = 0;    // of each following wave
    std::vector<int> pairs;     // of the camera's dimensions and a wave's: which of those that are drawn; -1: not drawn
    int pairs_of_wave = 0;      // drawn

    /// A dimension of the waves: its place among the pairs, and what its random numbers are made of.
    std::size_t place(int dimension) const {
        return std::size_t(dimension + (dimension < 0 ? int(pairs.size()) : camera_dimensions));
    }
    std::uint64_t number(int wave, int dimension) const {
        return std::uint64_t(dimension < 0 ? dimension - wave * most_new_dimensions
                                           : camera_dimensions + wave * wave_dimensions + dimension);
    }

    Sampling sampling;
};

/// A dimension that a plan draws, and how many random numbers it has.
struct DrawnDimension {
    int dimension, numbers;
};
std::vector<DrawnDimension> camera_drawn(const RenderPlan& plan);
std::vector<DrawnDimension> wave_drawn(const RenderPlan& plan);

RenderPlan make_plan(const Scene& scene, const Sampling& sampling);
inline RenderPlan make_plan(const Scene& scene) { return make_plan(scene, sampling_of(scene)); }

/// The plan as a short table: what is on, what is left out and why, dimensions per sample, expected rays per pixel, and
/// which fragments are called.
std::string describe(const RenderPlan& plan, const Scene& scene);

}  // namespace rt
