#pragma once

#include "diagnosis/calls/calls.h"

namespace grade {

/// What becomes of calls by a change of the fragment.
struct Effect {
    std::size_t wrong = 0, put_right = 0;  // calls that were wrong; that are right now
    bool breaks = false;                   // a call that was right, or the program

    bool is_all_right() const { return !breaks && put_right == wrong; }
};

/// answers  of the changed fragment, one for each call; fewer: it has ended
Effect effect_on(const Calls& calls, const Rows& answers);

}  // namespace grade
