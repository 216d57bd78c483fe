#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>

#include "assignment.h"
#include "build/files.h"
#include "build/sandbox.h"
#include "build/submission.h"
#include "build/toolchain.h"
#include "judging/kept.h"
#include "judging/progress.h"
#include "statistics/verdict.h"

namespace grade {

/// Which of a submission's fragments are compiled, and how they are linked.
struct BuildSettings {
    std::set<std::string> only;  // fragments to grade; empty: all
    bool apart = true;           // a program for each, with the solution's others
    bool together = false;       // one with all of the submission's, blanks where it has none
    int jobs = 0;                // at a time; 0: one for each core
    bool trusted = false;
    fs::path keep;               // where objects and programs stay; empty: nowhere
    Kept kept;                   // objects of an earlier grading, and for the next
};

/// A submission, compiled and linked: what a grading runs, whatever its seed.
class Programs {
public:
    /// Why a fragment has no program.
    struct Problem {
        Verdict verdict;  // not_started or did_not_build
        std::string message;
    };

    /// Compiles and links. What does not is a problem of that fragment only. Throws std::runtime_error where the
    /// machine or the solution fails.
    Programs(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
             const BuildSettings& settings, Progress& progress);

    const std::string& submission() const { return submission_; }
    const std::map<std::string, Problem>& problems() const { return problems_; }
    bool has(const std::string& fragment) const { return objects_.contains(fragment); }
    /// The text that the fragment was compiled from; empty: a blank stands in.
    std::string source(const std::string& fragment) const { return has(fragment) ? sources_.at(fragment) : ""; }
    const Sandbox& sandbox() const { return sandbox_; }

    /// The program that runs this fragment between the solution's others; that of all together; the solution's.
    const fs::path& apart(const std::string& fragment) const { return programs_.at(fragment); }
    const fs::path& together() const { return together_; }
    const fs::path& solution() const { return solution_; }

    /// Links those that are left once more, without these. Returns the program.
    fs::path together_without(const std::set<std::string>& fragments) const;

    /// A new folder in which a program may run.
    fs::path folder(const std::string& name) const;

private:
    void compile(const Submission& submission);
    void link_apart();
    void link_together();
    void fails(const std::string& fragment, const std::string& message);
    bool is_graded(const Fragment& fragment) const;
    std::string link(const std::string& fragment, const fs::path& program) const;
    std::string link_all(const std::map<std::string, fs::path>& own, const fs::path& program) const;

    std::string submission_;  // as it was given
    const Assignment& assignment_;
    const Toolchain& chain_;
    BuildSettings settings_;
    Progress& progress_;
    TemporaryFolder temporary_;
    fs::path work_;
    Sandbox sandbox_;
    std::map<std::string, Problem> problems_;
    std::map<std::string, fs::path> objects_, programs_;  // by fragment
    std::map<std::string, std::string> sources_;          // of what was compiled, by fragment
    fs::path solution_, together_;
    std::mutex lock_;
};

}  // namespace grade
