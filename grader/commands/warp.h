#pragma once

#include <string>

#include "checks/kit/check.h"
#include "programs/programs.h"
#include "programs/toolchain.h"

namespace grade {

/// The calls that show what a warp makes of random numbers: its last argument is a vec2.
///
/// words  its other arguments, as in a hint: "inner = 0.5"
/// Throws rt::InputError where the fragment is no warp, or the words are none of its arguments.
Rows calls_of_warp(const std::string& fragment, const std::string& words, const Toolchain& chain);

/// Draws the points that it answers, seen from above, in the square from -1 to 1: with this program and with the
/// solution's. Returns the exit code: 0; 1 where the program gave none.
///
/// time_limit  CPU seconds; 0: some
int draw_warp(const std::string& fragment, const Rows& calls, Programs& programs, const fs::path& mine,
              const Toolchain& chain, double time_limit, const fs::path& out);

}  // namespace grade
