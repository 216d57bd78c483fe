#pragma once

#include "programs/programs.h"
#include "stress/run.h"

namespace grade::stress {

/// The big counts: rays from within closed meshes, and rays that leave surfaces, at sizes of 2^-40 to 2^40.
std::vector<CountRecord> big_counts(Programs& programs, const fs::path& meshes, const StressSettings& settings);

}  // namespace grade::stress
