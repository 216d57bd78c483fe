#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>

#include "build/compile.h"
#include "build/files.h"
#include "build/sandbox.h"
#include "build/submission.h"
#include "build/toolchain.h"

namespace grade {

/// Programs with the submission's version of some fragments. Those that are the solution's word for word are not
/// compiled again.
class FamilyPrograms {
public:
    /// student  the submission's fragments with each other; else only those that a family is about, with the solution's
    /// others
    FamilyPrograms(const Submission& submission, const Toolchain& chain, const Sandbox& sandbox, bool student);

    /// Compiles those of these fragments that are the submission's own.
    void compile(const std::set<std::string>& fragments, int jobs);

    /// Why a fragment cannot be run; empty: it can.
    std::string complaint(const std::string& fragment) const;

    /// A program with the submission's version of these fragments; made once. Throws std::runtime_error.
    fs::path with(const std::set<std::string>& fragments);

    /// A folder of its own for a process, with the program in it.
    fs::path copy_for(const std::string& name, const fs::path& program) const;

private:
    const Submission& submission_;
    const Toolchain& chain_;
    const Sandbox& sandbox_;
    bool student_;
    TemporaryFolder work_;
    std::map<std::string, fs::path> own_;            // objects of the submission
    std::map<std::string, std::string> complaints_;  // by fragment
    std::map<std::set<std::string>, fs::path> linked_;
    mutable std::mutex lock_;
};

}  // namespace grade
