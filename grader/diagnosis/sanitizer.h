#pragma once

#include <string>

namespace grade {

/// What sanitizers said about a fragment, in a line: "phong.cpp:24: no value is returned". Empty: nothing that is
/// understood. What a program says is untrusted text.
std::string fault_in_words(const std::string& said, const std::string& fragment);

/// The number behind "/phong.cpp:", or behind "phong.cpp:"; 0: there is none.
int line_in(const std::string& text, const std::string& file);

}  // namespace grade
