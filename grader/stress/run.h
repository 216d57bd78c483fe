#pragma once

#include <vector>

#include "assignment/assignment.h"
#include "programs/programs.h"
#include "stress/record.h"
#include "submission/submission.h"

namespace grade::stress {

/// Whether a family has this name, or is of the fragment that has it.
bool is_named(const Family& family, const std::string& name);

struct StressSettings {
    std::vector<std::string> only;  // families, or fragments with all of theirs; empty: all
    BuildSettings build{.only_changed = true};
    double time_limit = 5;        // CPU time of one answer [s]
    double rays = 0;              // of the big counts on meshes; twice as many that leave surfaces; 0: none
    Progress::Listener progress;  // never called twice at a time
};

/// Runs families on a submission. Whatever a fragment does costs its families only. Throws std::runtime_error where the
/// machine fails.
StressRecord stress_submission(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
                               const StressSettings& settings);

/// The big counts: rays from within closed meshes, and rays that leave surfaces, at sizes of 2^-40 to 2^40.
std::vector<CountRecord> big_counts(Programs& programs, const fs::path& meshes, const StressSettings& settings);

}  // namespace grade::stress
