#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Nobody needs this file for the assignment.
namespace rt {

/// Without line breaks and other control characters.
std::string one_line(std::string text);

/// The word of the list that differs least; none: all of them differ in too many letters.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& words);

/// A user's word as it may stand in a message: in quotes, without control characters, not too long.
std::string in_quotes(std::string_view word);

/// Bytes as letters and digits, as RFC 4648 has it.
std::string base64(std::string_view bytes);

}  // namespace rt
