#pragma once

#include <string>

#include "diagnosis/calls.h"

namespace grade {

/// Says so where each number of the answers has the 24 bits of `float`, and the right ones have more. Empty: they have
/// not.
std::string in_single_precision(const Calls& calls);

}  // namespace grade
