#pragma once

#include "diagnosis/calls/arguments.h"

namespace grade {

/// Simpler values of a part of a row, the simplest first; those that are no simpler than what stands there are left
/// out.
std::vector<std::vector<double>> simpler_values(const Field& part, const Row& row);

}  // namespace grade
