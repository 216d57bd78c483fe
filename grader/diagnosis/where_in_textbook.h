#pragma once

#include "diagnosis/where.h"

namespace grade {

/// What sets wrong calls apart in the variables of a textbook's form; `otherwise`, where these do not.
WrongCalls where_wrong_in_textbook(const Calls& calls, WrongCalls otherwise);

}  // namespace grade
