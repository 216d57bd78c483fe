#pragma once

#include <string>

namespace grade {

/// What sanitizers said about a fragment, in a line: "phong.cpp:24: no value is returned". Empty: nothing that is
/// understood. What a program says is untrusted text.
std::string fault_in_words(const std::string& said, const std::string& fragment);

}  // namespace grade
