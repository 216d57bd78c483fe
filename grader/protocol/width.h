#pragma once

#include <cstddef>
#include <string_view>

namespace grade {

/// How many numbers an answer of a fragment has, with what its arguments note; 0 for a name that is no fragment's.
std::size_t width_of(std::string_view fragment);

}  // namespace grade
