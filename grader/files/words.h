#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace grade {

/// Without blanks at either end, and without the end of a line of DOS.
inline std::string trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == text.npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

/// Of a place in a text, from 1: "3:14".
inline std::string line_and_column(std::string_view text, std::size_t at) {
    const std::string_view before = text.substr(0, at);
    const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
    return fmt::format("{}:{}", 1 + std::ranges::count(before, '\n'), 1 + before.size() - start);
}

/// Without the ends of lines.
inline std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

inline std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small) c = char(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

}  // namespace grade
