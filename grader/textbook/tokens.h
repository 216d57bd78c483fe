#pragma once

#include <string>
#include <vector>

namespace grade::textbook {

struct Token {
    enum class Kind { name, number, sign, end };
    Kind kind = Kind::end;
    std::string text;
    int line = 1, column = 1;
    std::size_t from = 0, to = 0;  // in the text
};

/// How many end tokens stand behind the last one, for readers that look ahead.
constexpr int look_ahead = 4;

/// Of C++ without its comments and its lines for the preprocessor. "std::sqrt" is one name, a text in quotes one sign.
std::vector<Token> tokens_of(const std::string& text);

}  // namespace grade::textbook
