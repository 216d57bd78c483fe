#pragma once

#include <vector>

#include "rt/answers.h"
#include "rt/lanes.h"
#include "rt/sampler.h"

/// Rays in arrays: the state that flows from stage to stage.
namespace rt {

constexpr Index nothing = -1;  // a ray that meets no shape
constexpr Index ended = -2;    // a lane whose path goes on elsewhere or is over

/// The ray of a lane that has none: it ends before it begins, and meets nothing.
inline const Ray no_ray{vec3(0), vec3(0, 0, 1), 0, -inf};

/// Up to `lanes` paths, each with the ray it follows now. Lanes from `count` on are not in use.
struct alignas(64) Batch {
    int count = 0;

    // the ray; far shrinks to the nearest hit
    Vectors<> origin, direction;
    Real near[lanes], far[lanes];
    Real time[lanes];
    Index shape[lanes];

    // the path
    Colors weight;        // share of the arriving radiance that reaches the film
    Bits key[lanes];      // of its random numbers
    int sample[lanes];    // index in the pixel's pattern
    Index slot[lanes];    // which radiance of the chunk it adds to
    Index event[lanes];   // where the ray comes from: an Event
    Index depth[lanes];   // mirrors, glass and lobes so far
    Index bounce[lanes];  // diffuse bounces so far
    // With which a lobe or a medium took the ray, where it is weighed against lamps, else 0; only after these. After a
    // medium, times the share of light that its straight way here has left [1/sr].
    Real density[lanes];
    Real way[lanes];     // that is behind it since the medium; only where density is of one [m]
    Bits inside[lanes];  // the regions that the ray is in: see media/nesting.h; 0: none

    Ray ray(int i) const { return {origin.at(i), direction.at(i), near[i], far[i]}; }
    void set_ray(int i, const Ray& r) {
        origin.set(i, r.origin), direction.set(i, r.direction);
        near[i] = r.near, far[i] = r.far, shape[i] = nothing;
    }

    /// Lane j goes on with the path of lane i of another batch; its ray, weight and event are set apart.
    void continue_path(int j, const Batch& from, int i) {
        time[j] = from.time[i], key[j] = from.key[i], sample[j] = from.sample[i], slot[j] = from.slot[i];
        depth[j] = from.depth[i], bounce[j] = from.bounce[i], inside[j] = from.inside[i];
    }
};

/// What the surface stage finds at the hits of a batch.
struct alignas(64) Surfaces {
    Vectors<> point;
    Real error[lanes];
    Vectors<> flat, shading;  // the surface's own normal, and the one that light is reckoned with; on the ray's side
    Index material[lanes];    // nothing: no surface here
    Index behind[lanes];      // 1 where the ray came from the back side
    Index shines[lanes];      // 1 where the side that is seen sends out light

    vec3 normal(int i) const { return shading.at(i); }
    Hit hit(int i) const { return {point.at(i), flat.at(i), error[i]}; }
};

/// Digits of the first samples of an orthogonal array in one pair of its dimensions.
struct alignas(64) LaneDigits {
    std::uint32_t x[lanes], y[lanes];
};

/// A sampling pattern for n samples of each pixel.
struct Pattern {
    Sampler sampler;
    int n;
    const LaneDigits* digits = nullptr;  // of an orthogonal array, by column: what all pixels have in common
};

/// Random numbers of each lane in one dimension of the pattern; of a 1D one, x.
struct alignas(64) Numbers {
    Real x[lanes], y[lanes];
    vec2 at(int i) const { return {x[i], y[i]}; }
};

/// Paths that wait for the next wave, packed into full batches.
struct Queue {
    std::vector<Batch> batches;
    std::size_t used = 0;  // batches in use

    void clear() { used = 0; }

    /// The batch that is filled now: it has free lanes from its count on.
    Batch& open() {
        if (used == 0 || batches[used - 1].count == lanes) {
            if (used == batches.size()) batches.emplace_back();
            batches[used++].count = 0;
        }
        return batches[used - 1];
    }

    /// The next free lane. What is in it stays from its last use.
    std::pair<Batch&, int> push() {
        Batch& last = open();
        return {last, last.count++};
    }
};

/// What one thread works on: some pixels with all their samples.
struct Chunk {
    std::vector<Color> radiance;  // of each sample, slot by slot
    std::vector<Real> weight;     // of each sample in its pixel's mean
    RayCounts rays{};
};

}  // namespace rt
