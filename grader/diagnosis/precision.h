#pragma once

#include <string>

#include "diagnosis/calls.h"

namespace grade {

/// Says so where each number of the answers has the 24 bits of `float`, and the right ones have more, or where nearly
/// all differ from these from the seventh digit on. Empty: neither holds.
std::string in_single_precision(const Calls& calls);

/// A fragment with `double` in place of each `float`.
struct InDouble {
    Ask ask;
    int line;  // of its first `float`
};

/// Says so where that is all it takes; else empty.
std::string by_double(const Calls& calls, const InDouble& source);

}  // namespace grade
