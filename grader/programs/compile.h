#pragma once

#include <string>

#include "programs/sandbox.h"
#include "programs/toolchain.h"

namespace grade {

/// CPU time that a compiler may take for one fragment.
constexpr double most_compiler_seconds = 30;

/// What became of a fragment's source.
struct Compiled {
    bool good = false;
    fs::path object;       // where good; defines nothing but the fragment
    std::string message;   // else: the first errors, and what to do
    std::string warnings;  // where good: the compiler's first ones about the source, a line each
};

/// Compiles one fragment as the project compiles its own. What else the file defines, helpers, overrides of library
/// functions, stays private to the object.
///
/// Throws std::runtime_error where the disk is full or the compiler does not work.
///
/// text     the source
/// shown    its path in messages
/// work     an empty folder of its own
/// seconds  CPU time that the compiler may take
Compiled compile_fragment(const Toolchain& chain, const Sandbox& sandbox, const std::string& fragment,
                          const std::string& text, const std::string& shown, const fs::path& work,
                          double seconds = most_compiler_seconds);

/// Links a program that renders and answers probes with these objects. Empty: it worked; else the first errors.
/// Throws std::runtime_error where the disk is full.
std::string link_child(const Toolchain& chain, const Sandbox& sandbox, const std::vector<fs::path>& objects,
                       const fs::path& program);

}  // namespace grade
