#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "assignment/assignment.h"

namespace grade {

namespace fs = std::filesystem;

/// How a child is compiled and linked: exactly as the project's own programs are. CMake writes it, and a kit has one of
/// its own.
struct Toolchain {
    fs::path source;  // the folder of the assignment: starter/, scenes/, assignment.toml
    fs::path compiler;
    std::string description;           // "GNU 12.2.0, Release"
    bool is_gcc = true;                // which looks for compiled headers by itself
    std::string commit;                // what was checked out when it was built; empty: nobody knows
    std::string processor;             // the least kind that the archives run on: "x86-64-v2"; "": any
    bool is_kit = false;               // handed out: no sources of the solution, and the code that runs is its owner's
    std::vector<std::string> compile;  // flags
    std::vector<fs::path> includes;    // the framework's headers: starter/ first
    fs::path cache;                    // where what a run leaves for the next is kept, if it can be written; may be ""
    std::vector<std::string> link;     // flags, before the objects
    std::vector<fs::path> archives;    // the child and the framework, in the order of the link
    std::vector<std::string> libraries;                // after them
    fs::path blanks;                                   // the folder of the blank fragments' sources
    std::map<std::string, fs::path> blank_objects;     // by fragment
    std::map<std::string, fs::path> solution_objects;  // by fragment
    std::map<std::string, std::string> symbols;        // by fragment: its name for the linker
    bool checked = false;                              // by sanitizers

    /// Whether an object came with the grader, and is of no submission.
    bool is_given(const fs::path& object) const;

    /// All that is the grader's own, with the solution's objects.
    std::vector<fs::path> own_folders() const;
    bool is_own(const fs::path& file) const;
};

/// The same compiler, with sanitizers that end a program at the first undefined behaviour and say where it is.
Toolchain with_sanitizers(const Toolchain& chain);

/// The assignment's fragments, in its order, then those that it leaves out.
std::vector<std::string> all_fragments(const Toolchain& chain, const Assignment& assignment);

/// Paths in the file are relative to its folder. Throws std::runtime_error where the file or what it names is missing,
/// or made for another processor than this one.
Toolchain read_toolchain(const fs::path& path);

/// That of the folder that a toolchain is for. Throws rt::InputError.
Assignment assignment_of(const Toolchain& chain);

/// The toolchain file of this program: the one beside it, where it is part of a kit, else the one of the build that the
/// program stands in. Throws std::runtime_error where that was built in another place: its paths lead there.
fs::path own_toolchain();

/// Says in one line on stderr whose assignment counts, where a grader is called in the tree of another one.
void tell_whose_assignment(const fs::path& toolchain);

}  // namespace grade
