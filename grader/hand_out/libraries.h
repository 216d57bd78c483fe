#pragma once

#include <string>
#include <vector>

#include "programs/toolchain.h"

namespace grade {

/// Runs a tool of the compiler's to its end; what it printed.
std::string must_run(const std::vector<std::string>& command);

/// The libraries of a kit's programs that a plain system lacks, and the licences of all that they are made of.
///
/// machine  the kit's folder for this kind of machine
void write_libraries(const fs::path& program, const Toolchain& built, const fs::path& machine);

}  // namespace grade
