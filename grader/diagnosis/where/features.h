#pragma once

#include "diagnosis/where/where.h"

namespace grade {

/// What holds in the wrong calls and in no right one, or nearly so: one thing that arguments show, or two together.
WrongCalls rule_of(const Calls& calls, bool of_answers);

}  // namespace grade
