#pragma once

#include <cstdint>
#include <vector>

#include "rt/fragments.h"
#include "rt/sampler.h"

/// Rays in arrays: the state that flows from stage to stage.
namespace rt {

constexpr int lanes = 64;
using Index = std::int64_t;  // as wide as a Real, so that loops over both need no conversion

constexpr Index nothing = -1;  // a ray that meets no shape
constexpr Index ended = -2;    // a lane whose path goes on elsewhere or is over

/// Up to `lanes` paths, each with the ray it follows now. Lanes from `count` on are not in use.
struct alignas(64) Batch {
    int count = 0;

    // the ray; far shrinks to the nearest hit
    Real ox[lanes], oy[lanes], oz[lanes], dx[lanes], dy[lanes], dz[lanes], near[lanes], far[lanes];
    Real time[lanes];
    Index shape[lanes];

    // the path
    Real weight_r[lanes], weight_g[lanes], weight_b[lanes];  // share of the arriving radiance that reaches the film
    Bits key[lanes];      // of its random numbers
    int sample[lanes];  // index in the pixel's pattern
    Index slot[lanes];    // which radiance of the chunk it adds to
    Index event[lanes];   // where the ray comes from: an Event
    Index depth[lanes];   // mirrors, glass and lobes so far
    Index bounce[lanes];  // diffuse bounces so far
    Real density[lanes];  // with which a lobe took the ray, where it is weighed against lamps, else 0; only after lobes [1/sr]
    Bits inside[lanes];   // the regions that the ray is in: see media/nesting.h; 0: none

    Ray ray(int i) const { return {{ox[i], oy[i], oz[i]}, {dx[i], dy[i], dz[i]}, near[i], far[i]}; }
    void set_ray(int i, const Ray& r) {
        ox[i] = r.origin.x, oy[i] = r.origin.y, oz[i] = r.origin.z;
        dx[i] = r.direction.x, dy[i] = r.direction.y, dz[i] = r.direction.z;
        near[i] = r.near, far[i] = r.far, shape[i] = nothing;
    }
    /// Lane `to` becomes as lane `from` is.
    void copy_lane(int from, int to) {
        set_ray(to, ray(from));
        time[to] = time[from], shape[to] = shape[from];
        set_weight(to, weight(from));
        key[to] = key[from], sample[to] = sample[from], slot[to] = slot[from], event[to] = event[from], density[to] = density[from];
        depth[to] = depth[from], bounce[to] = bounce[from], inside[to] = inside[from];
    }
    Color weight(int i) const { return {weight_r[i], weight_g[i], weight_b[i]}; }
    void set_weight(int i, Color w) { weight_r[i] = w.x, weight_g[i] = w.y, weight_b[i] = w.z; }
};

/// What the surface stage finds at the hits of a batch.
struct alignas(64) Surfaces {
    Real px[lanes], py[lanes], pz[lanes], error[lanes];
    Real gx[lanes], gy[lanes], gz[lanes];  // geometric normal, on the side of the ray
    Real nx[lanes], ny[lanes], nz[lanes];  // shading normal, on the side of the ray
    Index material[lanes];  // nothing: no surface here
    Index behind[lanes];    // 1 where the ray came from the back side
    Index shines[lanes];    // 1 where the side that is seen sends out light

    vec3 normal(int i) const { return {nx[i], ny[i], nz[i]}; }
    Hit hit(int i) const { return {{px[i], py[i], pz[i]}, {gx[i], gy[i], gz[i]}, error[i]}; }
};

/// One colour a lane.
struct alignas(64) Colors {
    Real r[lanes], g[lanes], b[lanes];
    Color at(int i) const { return {r[i], g[i], b[i]}; }
    void set(int i, Color c) { r[i] = c.x, g[i] = c.y, b[i] = c.z; }
};

/// A sampling pattern for n samples of each pixel.
struct Pattern {
    Sampler sampler;
    int n;
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
