#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "programs/process.h"

namespace grade {

namespace fs = std::filesystem;

/// Where student code is compiled, linked and run: what it can see and do. See grader/SECURITY.md.
struct Sandbox {
    enum class Kind { host, container, limits_only };
    Kind kind = Kind::limits_only;
    std::string description;         // for the report: what it is, and why it is no better
    std::vector<fs::path> readable;  // seen by every step, beside what it names: libraries
    std::vector<fs::path> hidden;    // the grader's own folders: what a step does not name there it does not see
    bool own_user = false;           // in a container: each step is another user
};

/// A program that reads what comes from a student, or is made of it. It sees the system's programs and libraries, what
/// is readable, and its folder, where it starts; it has no network, and nothing of it is left when it has ended.
struct Step {
    std::vector<std::string> command;
    std::vector<fs::path> readable;
    fs::path folder;
    Limits limits;
    bool is_tool = true;  // may write into its folder and start other programs: a compiler; else a student's program
    bool sees_itself = false;  // has a /proc of its own, as sanitizers need
};

/// What this machine offers: bubblewrap, else Landlock and seccomp. Throws std::runtime_error where it offers neither.
///
/// trusted  the code is the caller's own: limits only
/// needed   files that steps must be able to read
/// hidden   as in Sandbox
Sandbox find_sandbox(bool trusted, const std::vector<fs::path>& needed = {}, const std::vector<fs::path>& hidden = {});

/// Why a sandbox does not work here; empty: it does.
std::string fault_of(const Sandbox& sandbox, const std::vector<fs::path>& needed);

/// Starts a step. Nothing else starts a process on a byte of a student's.
std::unique_ptr<Process> start(const Sandbox& sandbox, const Step& step);

/// Runs a step to its end; its stdin is empty.
Ending run(const Sandbox& sandbox, const Step& step);

}  // namespace grade
