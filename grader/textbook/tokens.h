#pragma once

#include <string>
#include <vector>

namespace grade::textbook {

struct Token {
    enum class Kind { name, number, sign, end };
    Kind kind = Kind::end;
    std::string text;
    int line = 1, column = 1;
};

/// Of C++ without its comments and its lines for the preprocessor. "std::sqrt" is one name.
std::vector<Token> tokens_of(const std::string& text);

}  // namespace grade::textbook
