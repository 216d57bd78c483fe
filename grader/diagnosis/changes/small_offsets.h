#pragma once

#include "diagnosis/changes/answer_forms.h"

namespace grade {

/// By what answers are off that are nearly right, such as an origin that is moved a little: a vector or a number of the
/// arguments, times a constant. Empty: they are right, or nothing tells.
std::string small_offsets(const Calls& calls);

}  // namespace grade
