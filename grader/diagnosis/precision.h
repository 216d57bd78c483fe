#pragma once

#include <string>

#include "diagnosis/calls.h"

namespace grade {

/// Says so where each number of the answers has the 24 bits of `float`, and the right ones have more, or where nearly
/// all differ from these from the seventh digit on. Empty: neither holds.
std::string in_single_precision(const Calls& calls);

}  // namespace grade
