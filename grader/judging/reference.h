#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "judging/experiment.h"

namespace grade {

/// What the solution gives for one check: run as far as it is asked for.
class Reference {
public:
    /// program  a child with the solution's fragments; it is started at the first question
    Reference(const Check& check, std::uint64_t seed, const fs::path& program, const Sandbox& sandbox,
              const fs::path& meshes);

    /// Of every statistic, in the submission's first replicate.
    std::vector<double> exact();

    /// Of every statistic, in a replicate of its own.
    std::vector<double> replicate(int which);

    /// Whether two seeds give two pictures, beyond rounding.
    bool noisy();

    /// Of the fastest replicate, since the first is slower than all others.
    double cpu_seconds();

    /// The picture with the seed of one of the submission's replicates, of a check that renders.
    const rt::Image& image(int which);

    /// The mean picture of the submission's first replicates, of a check that renders.
    rt::Image picture(int replicates);

private:
    const Observation& with_seed_of_submission(int which);
    Observation run(std::uint64_t seed);

    const Check& check_;
    std::uint64_t seed_;
    fs::path program_;
    const Sandbox& sandbox_;
    fs::path meshes_;
    std::unique_ptr<Runner> runner_;
    std::vector<Observation> own_;                                  // of the submission's seeds
    double cpu_seconds_ = std::numeric_limits<double>::infinity();  // of the fastest run
};

}  // namespace grade
