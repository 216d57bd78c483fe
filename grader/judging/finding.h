#pragma once

#include <vector>

#include "checks/kit/check.h"
#include "programs/programs.h"
#include "record/record.h"

namespace grade {

/// What calls of a fragment with failed checks show about its mistake; nothing where it crashes, takes too long or
/// needs too much memory.
///
/// checks      all checks of the grading with this seed
/// not_finite  whether one of its checks had answers that are no numbers
Finding find_cause(Programs& programs, const Toolchain& chain, const std::string& fragment,
                   const std::vector<Check>& checks, std::uint64_t seed, bool not_finite);

}  // namespace grade
