#pragma once

#include <string>
#include <string_view>

namespace grade {

/// Where the paths of a pixel part from the solution's: the lines of the sample's trace until there, then both
/// programs' next ones. Empty: nowhere.
///
/// mine, right  what the programs tell of the same pixel, with the same random numbers; mine is untrusted
std::string first_divergence(std::string_view mine, std::string_view right);

}  // namespace grade
