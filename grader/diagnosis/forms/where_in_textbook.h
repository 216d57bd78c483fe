#pragma once

#include "diagnosis/where/where.h"

namespace grade {

/// What sets wrong calls apart, in arguments or in variables of a textbook's form; in these rather than in the right
/// answers.
///
/// is_known  what is wrong is told: then only in arguments
WrongCalls region_of(const Calls& calls, bool is_known);

}  // namespace grade
