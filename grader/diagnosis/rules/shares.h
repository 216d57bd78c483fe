#pragma once

#include "diagnosis/calls/calls.h"

namespace grade {

/// Where an answer is a sum of what several colours of the arguments add, as diffuse light and a highlight: which of
/// these shares are wrong, and how. Empty: it is no such sum, or nothing tells its shares apart.
std::string wrong_shares(const Calls& calls, const Ask& mine, const Ask& right);

}  // namespace grade
