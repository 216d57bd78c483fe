#include "class/fingerprint.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "files/sha256.h"
#include "textbook/tokens.h"

namespace grade::course {

namespace {

constexpr std::array<std::string_view, 42> own_words = {
    "auto",     "bool",     "break",     "case",   "char",    "const",    "constexpr", "continue", "default",
    "do",       "double",   "else",      "enum",   "false",   "float",    "for",       "if",       "inline",
    "int",      "long",     "namespace", "return", "short",   "signed",   "sizeof",    "static",   "struct",
    "switch",   "template", "this",      "true",   "typedef", "typename", "unsigned",  "using",    "void",
    "volatile", "while",    "new",       "delete", "mutable", "operator"};

}  // namespace

Fingerprint fingerprint(const std::string& text) {
    using textbook::Token;
    std::map<std::string, std::size_t> names;
    std::string tokens;
    Fingerprint print;
    for (const Token& token : textbook::tokens_of(text)) {
        if (token.kind == Token::Kind::end) break;
        if (token.kind == Token::Kind::name && std::ranges::count(own_words, token.text) == 0)
            tokens += 'v' + std::to_string(names.try_emplace(token.text, names.size()).first->second);
        else
            tokens += token.text;
        tokens += ' ';
        ++print.tokens;
    }
    print.hash = sha256(tokens);
    return print;
}

}  // namespace grade::course
