#pragma once

#include "convergence/keep.h"
#include "convergence/record.h"

namespace grade {

/// One sampler of one program while it is measured.
struct Gathered {
    Who who;
    std::string sampler;
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

KeptResult to_kept(const Gathered& gathered);

/// The levels and pictures of what was kept. Throws nlohmann::json::exception, std::out_of_range.
void take(Gathered& gathered, const KeptResult& kept);

}  // namespace grade
