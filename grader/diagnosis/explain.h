#pragma once

#include "diagnosis/calls/calls.h"
#include "diagnosis/rules/precision.h"
#include "diagnosis/source/repair.h"
#include "record/record.h"

namespace grade {

/// A fragment compiled from other texts than its own; each is made at the first call. None: it cannot be made.
struct Recompiled {
    std::function<std::optional<Editable>()> editable{};  // with expressions that can be changed
    MadeInDouble in_double{};                             // none as well where it has no `float`
    std::vector<MadeInDouble> with_reals{};               // in place of a whole number each
    std::function<Rows()> more_calls{};                   // of its checks, which a change must put right as well
};

/// What calls of a fragment show about its mistake: the same for every fragment, from its declaration alone. Asks both
/// for no more than a second's worth of calls. Nothing is found where the fragment gives no answers.
///
/// rows    calls that its checks make
/// source  the fragment compiled from other texts
Finding explain(const Signature& signature, const Rows& rows, const Ask& mine, const Ask& right,
                const Recompiled& source = {});

}  // namespace grade
