#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace grade {

/// C++ text without comments and without white space outside of literals: two files that agree in this say the same.
std::string code_only(std::string_view text);

/// Whether a fragment's text is still the blank of that path, or returns as the blank does before it does anything.
bool is_blank(const std::string& text, const std::filesystem::path& blank);

}  // namespace grade
