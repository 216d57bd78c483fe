#pragma once

#include "programs/runner.h"

namespace grade {

/// One call of a fragment that is its user's own: without a sandbox, with the grader's stdout and stderr, so that its
/// prints are seen as they come.
///
/// program   a child, in a folder that may be written into
/// seconds   CPU time for the answer
/// debugger  in gdb, which stops where the fragment begins
/// Throws std::runtime_error where no process can be made.
Outcome<Row> call_in_view(const fs::path& program, const std::string& fragment, const Row& row, double seconds,
                          bool debugger);

}  // namespace grade
