#pragma once

#include <optional>

#include "diagnosis/calls/calls.h"

namespace grade {

/// What wrong answers have to do with right ones where random numbers may be used in another way: not call by call, but
/// as they are spread over many random numbers, for any of all calls. None: they are spread as they must be.
std::optional<std::string> spread_of(const Calls& calls, const Calls& all, const Ask& mine, const Ask& right);

/// That samples come in steps, or have few values, where right ones may be anywhere; empty: they do not.
std::string coarse_spread(const Calls& calls, const Ask& mine, const Ask& right);

}  // namespace grade
