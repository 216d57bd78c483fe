#pragma once

#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "judging/experiment.h"

namespace grade {

/// Adds one more picture to the mean of so many.
void add_picture(rt::Image& mean, const rt::Image& next, std::size_t count);

/// Children with the solution's fragments, which keep nothing between checks. A process ends with the thread that
/// started it, so each thread has its own.
class SolutionRunners {
public:
    SolutionRunners(const fs::path& program, const Sandbox& sandbox, const fs::path& meshes)
        : program_(program), sandbox_(sandbox), meshes_(meshes) {}

    /// That of this thread, else a new one. From any thread.
    std::unique_ptr<Runner> take();
    void give_back(std::unique_ptr<Runner> runner);

private:
    fs::path program_;
    const Sandbox& sandbox_;
    fs::path meshes_;
    std::mutex lock_;
    std::map<std::thread::id, std::unique_ptr<Runner>> free_;
};

/// What the solution gives for one check: run as far as it is asked for.
class Reference {
public:
    Reference(const Check& check, std::uint64_t seed, SolutionRunners& runners)
        : check_(check), seed_(seed), runners_(runners) {}
    ~Reference();
    Reference(const Reference&) = delete;
    Reference& operator=(const Reference&) = delete;

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

    /// What each of the solution's fragments answers along the paths of a pixel of image(0).
    std::string trace(rt::ivec2 pixel);

    /// The mean picture of the submission's first replicates, of a check that renders.
    rt::Image picture(int replicates);

private:
    const Observation& with_seed_of_submission(int which);
    Observation run(std::uint64_t seed);

    const Check& check_;
    std::uint64_t seed_;
    SolutionRunners& runners_;
    std::unique_ptr<Runner> runner_;                                // from the first question on
    std::vector<Observation> own_;                                  // of the submission's seeds
    double cpu_seconds_ = std::numeric_limits<double>::infinity();  // of the fastest run
};

}  // namespace grade
