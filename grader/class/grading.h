#pragma once

#include "class/results.h"
#include "programs/toolchain.h"
#include "studies/shard.h"

namespace grade::course {

/// How one call grades a class.
struct ClassSettings {
    GradingSettings grading;  // of each submission
    Shard shard;
    int jobs = 0;  // submissions at a time; 0: one for each core
};

struct Outcome {
    int graded = 0, before = 0;
    std::vector<std::string> troubles;  // of the machine: what could not be graded, and why
};

/// What each entry is graded under, and what its texts look like.
std::vector<Result> results_of(const std::vector<Entry>& entries, const Assignment& assignment, const Toolchain& chain,
                               const GradingSettings& settings);

/// Grades what has no record yet, each in a file of its own that is written when it is complete: a call that is
/// stopped, or killed, is gone on with by the next. The machine's trouble costs one submission of this call only; after
/// three in a row there is no use in going on.
Outcome grade_all(const std::vector<Entry>& entries, const std::vector<Result>& results, const Assignment& assignment,
                  const Toolchain& chain, const ClassSettings& settings, const fs::path& out);

}  // namespace grade::course
