#pragma once

#include "diagnosis/calls/calls.h"

namespace grade {

/// A unit vector of the arguments, or one of them mirrored at another, as a highlight's.
struct Direction {
    std::string words;               // "`d`", "`d` mirrored at `n`"
    std::string code;                // "2 * dot(n, d) * n - d"
    std::vector<std::size_t> parts;  // of the arguments: of what is mirrored, then at what
    std::function<rt::vec3(const Row& row, const Layout& layout)> value;
};

/// Of vectors that have length 1 in all calls, and are told.
std::vector<Direction> directions_of(const Calls& calls, const std::vector<bool>& told);

}  // namespace grade
