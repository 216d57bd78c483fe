#pragma once

#include <optional>

#include "diagnosis/calls/calls.h"

namespace grade {

/// The calls with those random numbers with which the solution puts its sample where mine is, so that the rest of both
/// answers can be compared whatever a fragment does with its numbers. Calls in which there are none
/// are left out. None: too few are left.
std::optional<Calls> with_own_numbers(const Calls& calls, const Ask& right);

/// The solution, with those numbers in place of the call's where it can; `like` has calls of such a layout.
Ask at_own_places(const Calls& like, const Ask& mine, const Ask& right);

}  // namespace grade
