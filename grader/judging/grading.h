#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "assignment.h"
#include "build/submission.h"
#include "build/toolchain.h"
#include "checks/kit/check.h"
#include "judging/programs.h"
#include "judging/reference.h"
#include "report/record.h"

namespace grade {

/// The seed of every grading without a solution: what was stored fits it.
constexpr std::uint64_t student_seed = 1;

struct GradingSettings {
    std::set<std::string> only;    // fragments to grade; empty: all
    std::uint64_t seed = 1;
    bool student = false;          // the submission's fragments with each other; else each with the solution's others
    int jobs = 0;                  // at a time; 0: one for each core
    double time_limit = 10;        // CPU time of one answer [s]
    bool trusted = false;
    bool pictures = false;         // for the page
    fs::path keep;                 // where objects and programs stay; empty: nowhere
    fs::path own_scene;            // scene of the submission's own picture; empty: none
    Kept kept;                     // in student mode: what need not be done again
    int replicates = 256;          // of a statistic, after which it is inconclusive
    int statistics = 0;            // that share alpha; 0: those of these checks

    std::function<void(int done, int all, const std::string& doing)> progress;  // never called twice at a time
    std::function<void(const Record&)> partial;                                 // after each fragment; likewise
};

/// Grades a submission: compiles its fragments, links each with those of others, runs the checks on them, and judges
/// what comes back. Whatever a fragment does costs that fragment only. Throws std::runtime_error where the machine
/// fails.
Record grade_submission(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
                        const std::vector<Check>& checks, const GradingSettings& settings);

/// What a grading with these settings needs.
BuildSettings build_settings(const GradingSettings& settings);

/// The part of a grading after compiling and linking: the same programs may be graded with many seeds.
Record grade_programs(const Programs& programs, const Assignment& assignment, const Toolchain& chain,
                      const std::vector<Check>& checks, const GradingSettings& settings, Progress& progress);

/// Runs every check on the solution alone, and keeps its scalars for student mode.
///
/// replicates  of each check that has a statistic without closed form
std::map<std::string, StoredCheck> make_references(
    const Toolchain& chain, const std::vector<Check>& checks, int replicates, int jobs,
    const std::function<void(int done, int all, const std::string& doing)>& progress);

}  // namespace grade
