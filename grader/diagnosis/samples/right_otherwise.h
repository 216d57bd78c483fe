#pragma once

#include "diagnosis/calls/calls.h"

namespace grade {

/// The answers of a sampled fragment, with the right ones in place of those that are right in another way: of all calls
/// with one value of a choice, as of one kind of lamp, whose samples integrate what the solution's do over their
/// directions. Call by call these are not the solution's, and nothing is wrong in them.
///
/// rows  calls that the checks make
Ask without_right_ones(const Signature& signature, const Rows& rows, const Ask& mine, const Ask& right);

}  // namespace grade
