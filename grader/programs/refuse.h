#pragma once

#include "programs/toolchain.h"

namespace grade {

/// Throws std::runtime_error where this program, or how fragments are compiled, does not compute as IEEE 754 has it:
/// its verdicts could not be defended.
void refuse_other_arithmetic(const Toolchain& chain);

}  // namespace grade
