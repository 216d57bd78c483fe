#pragma once

#include "diagnosis/calls.h"

namespace grade {

struct Example {
    Row row, mine, right;
};

/// The simplest call that goes wrong: from one that does, simpler values are tried as long as they do, and as long as
/// what all calls have in common stays: unit vectors, right angles, which of two is larger, ranges.
Example simplest_wrong(const Calls& calls, const Ask& mine, const Ask& right);

}  // namespace grade
