#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace grade {

/// Without blanks at either end, and without the end of a line of DOS.
inline std::string trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == text.npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

inline std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small) c = char(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

}  // namespace grade
