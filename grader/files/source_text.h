#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

/// Steps through the text of a C++ source.
namespace grade {

/// Of a name or a number.
inline bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Behind the comment that begins there; the same place: none does. One without end goes on to that of the text.
inline std::size_t behind_comment(std::string_view text, std::size_t at) {
    if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
    if (text.substr(at, 2) != "/*") return at;
    const std::size_t end = text.find("*/", at + 2);
    return end == text.npos ? text.size() : end + 2;
}

/// Behind the quote that ends the string or the character that begins there, or behind its line; the same place: none
/// does. The quote in 1'000 begins nothing.
inline std::size_t behind_quoted(std::string_view text, std::size_t at) {
    const char quote = text[at];
    if (quote != '"' && (quote != '\'' || (at > 0 && is_word(text[at - 1])))) return at;
    std::size_t end = at + 1;
    while (end < text.size() && text[end] != quote && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text.size());
}

}  // namespace grade
