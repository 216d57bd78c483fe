#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "judging/experiment.h"

namespace grade {

/// The solution's scalars for one check, kept for those who have no solution.
struct StoredCheck {
    std::vector<double> exact;                    // of each statistic, in the submission's first replicate
    std::vector<std::vector<double>> replicates;  // of each replicate, one for each statistic
    bool noisy = false;                           // two seeds give two pictures
    double cpu_seconds = 0;                       // of one replicate
};

/// What the solution gives for one check: run live, as far as it is asked for, or read from what was stored.
class Reference {
public:
    /// Nothing is known.
    Reference() = default;

    /// program  a child with the solution's fragments; it is started at the first question
    Reference(const Check& check, std::uint64_t seed, const fs::path& program, const Sandbox& sandbox,
              const fs::path& meshes);

    explicit Reference(StoredCheck stored) : stored_(std::move(stored)) {}

    /// Of every statistic, in the submission's first replicate. None: not known.
    std::optional<std::vector<double>> exact();

    /// Of every statistic, in a replicate of its own. None: not known.
    std::optional<std::vector<double>> replicate(int which);

    /// Whether two seeds give two pictures, beyond rounding. None: not known.
    std::optional<bool> noisy();

    /// Of the fastest replicate, since the first is slower than all others. None: not known.
    std::optional<double> cpu_seconds();

    /// The picture with the seed of one of the submission's replicates. None: not known, or the check renders nothing.
    std::optional<rt::Image> image(int which);

    /// The mean picture of the submission's first replicates. None: not known, or the check renders nothing.
    std::optional<rt::Image> picture(int replicates);

private:
    struct Live {
        Check check;
        std::uint64_t seed;
        fs::path program;
        Sandbox sandbox;
        fs::path meshes;
        std::unique_ptr<Runner> runner;
        std::vector<Observation> own;  // of the submission's seeds
        double cpu_seconds = std::numeric_limits<double>::infinity();  // of the fastest run

        const Observation& with_seed_of_submission(int which);
        Observation run(std::uint64_t seed);
    };
    std::unique_ptr<Live> live_;
    std::optional<StoredCheck> stored_;
};

/// Stored checks by key_of, from a folder of JSON files; empty where there is none. Throws std::runtime_error.
std::map<std::string, StoredCheck> read_references(const fs::path& folder);

/// Writes one file for each fragment. Throws std::runtime_error.
void write_references(const fs::path& folder, const std::vector<Check>& checks,
                      const std::map<std::string, StoredCheck>& stored, std::uint64_t seed);

}  // namespace grade
