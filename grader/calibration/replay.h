#pragma once

#include <cstdint>
#include <vector>

#include "calibration/pool.h"
#include "statistics/engine.h"

namespace grade::calibration {

/// Checks of one grading seed, each with its store.
struct PooledCheck {
    const Check* check;
    const Pool* pool;
};
using PooledChecks = std::vector<PooledCheck>;

/// What became of replayed gradings.
struct Tally {
    long gradings = 0, passed = 0, failed = 0, inconclusive = 0;
    double replicates = 0;   // of all checks, of all gradings
    double cpu_seconds = 0;  // likewise, at what a replicate of the store cost

    void add(const Tally& other);
    double seconds_per_grading() const { return gradings > 0 ? cpu_seconds / double(gradings) : 0; }
};

/// Grades again and again with replicates drawn from stores, with replacement, by the code that decides in a grading.
///
/// seeds      the same checks with the parameters of several grading seeds; each replayed grading takes one of them
/// settings   as in a grading: alpha is shared by all statistics of the assignment
/// random     seed of the draws
Tally replay(const std::vector<PooledChecks>& seeds, const Settings& settings, long gradings, std::uint64_t random);

/// The same with a test of fixed size, of the same alpha and beta, in place of the code that stops when it is certain:
/// a statistic fails where Student's test rejects |m| <= delta0, passes where |m| <= delta is shown, and is
/// inconclusive otherwise.
///
/// replicates  of each check, at least 2
Tally replay_fixed(const std::vector<PooledChecks>& seeds, const Settings& settings, int replicates, long gradings,
                   std::uint64_t random);

}  // namespace grade::calibration
