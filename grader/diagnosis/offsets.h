#pragma once

#include "diagnosis/calls.h"

namespace grade {

/// By what answers are off that are nearly right, such as an origin that is moved a little: in words; empty: they are
/// right, or nothing tells.
std::string small_offsets(const Calls& calls);

}  // namespace grade
