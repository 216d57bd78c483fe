#pragma once

#include <string>
#include <string_view>

namespace grade {

/// SHA-256 of these bytes, as `sha256sum` prints it: what a record was made of can be held against a file by anyone.
///
/// Source: FIPS 180-4, "Secure Hash Standard", 6.2.
std::string sha256(std::string_view bytes);

}  // namespace grade
