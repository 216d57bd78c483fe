#pragma once

#include "diagnosis/calls.h"

/// What one part of an answer is, compared with the right one.
namespace grade {

struct Form {
    std::string words;  // "is 2 times too large"; empty: it is right
    double cost = 0;
};

/// The simplest form in the calls of `scope` with which `mine` follows from `right`; none: there is none. Where only
/// simple ones are asked for: the same, the opposite sign, a constant factor.
std::optional<Form> form_of(const Calls& calls, const Field& part, const Rows& right,
                            const std::vector<std::size_t>& scope, bool only_simple);

}  // namespace grade
