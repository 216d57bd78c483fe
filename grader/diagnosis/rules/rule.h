#pragma once

#include "diagnosis/calls/calls.h"

namespace grade {

/// Of a fragment that sums values of a function or of a list, what it takes of each, found by asking it for sums of
/// which all values but some are 0: "f(0) + f(1) + f(2)"; or where it asks another function that it is given. Empty
/// where it does as the right one, and for other fragments.
std::string wrong_rule(const Calls& calls, const Ask& mine, const Ask& right);

}  // namespace grade
