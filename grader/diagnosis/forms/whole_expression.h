#pragma once

#include <optional>

#include "diagnosis/forms/mistakes.h"

namespace grade {

/// Where a change of one expression reads better as one of the sum, product, condition or choice that it is an operand
/// of, that: "a - b" for "a + b" with -b in place of b, "b" for "1 * b", "n + 1" for "n + 2", "a" for "true ? a : b".
std::optional<Mistake> of_whole(const Expressions& all, const Mistake& change);

}  // namespace grade
