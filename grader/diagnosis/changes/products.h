#pragma once

#include "diagnosis/changes/answer_forms.h"

/// Answers as products of powers of quantities, found as sums of logarithms.
namespace grade {

/// Mine is a quantity of the arguments, or a product of two: "is `2 * focus^-1`".
std::optional<AnswerForm> quantity_of(const PartOfCalls& of);

/// Mine is the right one times such a product: "is `dot(n, to_light)` times what it must be".
std::optional<AnswerForm> product_of(const PartOfCalls& of);

/// Mine is the right one and such a product: "is what it must be, and `1 / extinction` more".
std::optional<AnswerForm> difference_of(const PartOfCalls& of);

}  // namespace grade
