#pragma once

#include "diagnosis/calls.h"
#include "diagnosis/changes.h"

namespace grade {

/// Changes with a constant that is found, not known: "`0.9 * u.y` in place of `u.y`", "`min(exponent, 30)`". The
/// constant is the one with which the solution answers some of the wrong calls as the fragment does.
///
/// wrong  calls that are wrong
std::vector<Change> changes_with_constants(const Calls& calls, const Ask& right, const std::vector<std::size_t>& wrong);

}  // namespace grade
