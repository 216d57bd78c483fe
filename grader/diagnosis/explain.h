#pragma once

#include "diagnosis/calls.h"
#include "diagnosis/repair.h"
#include "record/record.h"

namespace grade {

/// What calls of a fragment show about its mistake: the same for every fragment, from its declaration alone. Asks both
/// for no more than a second's worth of calls. Nothing is found where the fragment gives no answers.
///
/// rows    calls that its checks make
/// source  makes the fragment with expressions that can be changed, at the first call; none: it cannot be made
Finding explain(const Signature& signature, const Rows& rows, const Ask& mine, const Ask& right,
                const std::function<std::optional<Editable>()>& source = {});

}  // namespace grade
