#pragma once

#include "convergence/record.h"
#include "programs/kept_file.h"

namespace grade::convergence {

/// What has been measured of one sampler of one program so far.
struct Measured {
    std::vector<Level> levels;  // ascending
    // means, weighted by the samples, of the pictures with even and with odd numbers: what they have in common is no
    // noise
    std::array<rt::Image, 2> means;
    std::array<double, 2> weights{};

    /// None: not measured yet.
    const Run* find(int samples, int replicate) const;

    /// The replicates of a level must come in their order.
    void add(int samples, int replicate, const Run& run, const rt::Image& image);
};

KeptJson to_kept(const Measured& measured);
Measured measured_of(const KeptJson& kept);

}  // namespace grade::convergence
