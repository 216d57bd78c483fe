#pragma once

#include <functional>
#include <future>
#include <random>
#include <set>
#include <string>

#include "assignment/assignment.h"
#include "checks/kit/check.h"
#include "programs/programs.h"
#include "record/record.h"

namespace grade {

struct GradingSettings {
    std::set<std::string> only;  // fragments to grade; empty: all
    std::uint64_t seed = 1;
    double time_limit = 5;  // CPU time of one answer [s]
    bool pictures = false;  // for the page
    bool explains = true;   // looks for the cause where calls are wrong
    int replicates = 256;   // of a statistic, after which it is inconclusive
    int statistics = 0;     // that share alpha; 0: those of these checks
    std::string command;    // that it was asked for with
    Provenance provenance;  // but for its checks; empty where no record is kept
    BuildSettings build;

    Progress::Listener progress;                 // never called twice at a time
    std::function<void(const Record&)> partial;  // before all, and after each check; likewise
};

/// A seed that nobody knows before.
inline std::uint64_t fresh_seed() {
    std::random_device device;
    return device() % 1'000'000 + 1;
}

/// Checks that may still be made: their closed forms take a while, in which fragments can be compiled.
using FutureChecks = std::shared_future<std::vector<Check>>;

/// Grades a submission: compiles its fragments, links each with the solution's others, runs the checks on them, and
/// judges what comes back. Whatever a fragment does costs that fragment only. Throws std::runtime_error where the
/// machine fails.
Record grade_submission(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
                        const FutureChecks& checks, const GradingSettings& settings);

/// The same with fragments that are compiled already, as far as they are needed: the same programs may be graded with
/// many seeds.
Record grade_programs(Programs& programs, const Assignment& assignment, const Toolchain& chain,
                      const FutureChecks& checks, const GradingSettings& settings, Progress& progress);

/// Checks that are made.
FutureChecks ready(std::vector<Check> checks);

}  // namespace grade
