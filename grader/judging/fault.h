#pragma once

#include <vector>

#include "checks/kit/check.h"
#include "programs/programs.h"
#include "record/record.h"

namespace grade {

/// Runs what crashed, gave no number, or answered differently when asked twice once more, with sanitizers:
/// "phong.cpp:24: a way through this function ends without a return". Empty where they find nothing, or where there are
/// none.
///
/// checks  all checks of the grading with this seed
std::string find_fault(const Programs& programs, const Programs::Linked& plain, const Toolchain& chain,
                       const FragmentRecord& fragment, const std::vector<Check>& checks, std::uint64_t seed);

}  // namespace grade
