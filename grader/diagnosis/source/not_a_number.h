#pragma once

#include "diagnosis/source/repair.h"

namespace grade {

/// The expression of the source that is nan before any other, in most calls whose answer is: "`f * v` in line 14, where
/// `f` is infinite". Empty: it is not known.
std::string first_not_a_number(const Calls& calls, const Editable& source);

}  // namespace grade
