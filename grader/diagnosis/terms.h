#pragma once

#include "diagnosis/answer_forms.h"

namespace grade {

/// Mine is a sum of one or two vectors of the arguments, times constants, numbers or dot products; the right one may be
/// such a sum as well: "is `d + 2 * dot(d, n) * n`, must be `d - 2 * dot(d, n) * n`".
std::optional<AnswerForm> terms_of(const PartOfCalls& of);

/// By what answers are off that are nearly right, such as an origin that is moved a little, in words; empty: they are
/// right, or nothing tells.
std::string small_offsets(const Calls& calls);

}  // namespace grade
