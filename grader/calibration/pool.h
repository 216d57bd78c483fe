#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "checks/kit/check.h"
#include "judging/reference.h"

namespace grade::calibration {

/// So many replicates of a program break down, and it is not started again.
constexpr int most_faults = 8;

/// The scalars of many replicates of one check, from one program: what replays draw from.
struct Pool {
    int statistics = 0;
    int faults = 0;               // replicates that crashed, did not end or were no image: rows of NaN
    bool unfit = false;           // fails before any statistic
    bool ignores_seed = false;    // two seeds, one picture
    double cpu_seconds = 0;       // of all replicates
    std::vector<double> scalars;  // replicates x statistics

    int replicates() const { return statistics > 0 ? int(scalars.size()) / statistics : 0; }
    double scalar(int replicate, std::size_t statistic) const {
        return scalars[std::size_t(replicate) * std::size_t(statistics) + statistic];
    }
    /// Whether so many are there, or as many as a program gives that breaks down.
    bool has(int wanted) const { return replicates() >= wanted || faults >= most_faults; }
    double seconds_per_replicate() const { return replicates() > 0 ? cpu_seconds / replicates() : 0; }
};

/// Runs a check so many times. A program that breaks down is started again, a few times.
///
/// meshes  where scenes look for meshes
/// before  replicates of the same that are there already: only others are run
Pool collect(const Check& check, std::uint64_t seed, int replicates, const fs::path& program,
             const fs::path& solution_program, const Sandbox& sandbox, const fs::path& meshes, Pool before = {});

/// Throws std::runtime_error.
void write_pool(const fs::path& path, const Pool& pool);

/// None: there is no such file, or it is not whole.
std::optional<Pool> read_pool(const fs::path& path);

}  // namespace grade::calibration
