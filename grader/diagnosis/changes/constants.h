#pragma once

#include <string>

/// Constants as people write them.
namespace grade {

/// "1.005": with as many digits as tell it from 1.
std::string ratio_in_words(double ratio);

/// "pi", "1 / pi", or digits.
std::string constant(double x);

/// Whether it has a name, as 2, pi and their inverses have.
bool is_named(double x);

}  // namespace grade
