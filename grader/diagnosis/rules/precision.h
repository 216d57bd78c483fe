#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/calls/calls.h"

namespace grade {

/// Says so where each number of the answers has the 24 bits of `float`, and the right ones have more, or where nearly
/// all differ from these from the seventh digit on. Empty: neither holds.
std::string in_single_precision(const Calls& calls);

/// A fragment with `double` in place of each `float`, or of a whole number.
struct InDouble {
    Ask ask;
    int line;           // of the first
    const char* words;  // "`double` in place of `float`"
    const char* since;  // why that is wrong
};

/// Says so where that is all it takes; else empty.
std::string by_double(const Calls& calls, const InDouble& source);

/// One that is compiled when it is called; none: it cannot be.
using MadeInDouble = std::function<std::optional<InDouble>()>;

/// What is said of a line of the source.
struct InLine {
    std::string words;
    int line = 0;
};

/// Says so of the first of these behind the first one that is all it takes; of that one, where none is. Empty where the
/// first one, which changes what each of the others does, is not enough: the others are not compiled then.
InLine by_reals(const Calls& calls, const std::vector<MadeInDouble>& sources);

/// Whether all answers are nearly right.
bool are_near(const Calls& all);

}  // namespace grade
