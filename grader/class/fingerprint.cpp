#include "class/fingerprint.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "files/sha256.h"
#include "files/source_text.h"

namespace grade::course {

namespace {

constexpr std::array<std::string_view, 44> own_words = {
    "auto",   "bool",   "break",    "case",      "char",   "const",  "constexpr", "continue", "default",
    "do",     "double", "else",     "enum",      "false",  "float",  "for",       "if",       "include",
    "inline", "int",    "long",     "namespace", "return", "short",  "signed",    "sizeof",   "static",
    "std",    "struct", "switch",   "template",  "this",   "true",   "typedef",   "typename", "unsigned",
    "using",  "void",   "volatile", "while",     "new",    "delete", "mutable",   "operator"};

bool is_letter(char c) { return is_word(c) && std::isdigit(static_cast<unsigned char>(c)) == 0; }

}  // namespace

Fingerprint fingerprint(std::string_view text) {
    std::map<std::string_view, std::size_t> names;
    std::string tokens;
    Fingerprint print;
    for (std::size_t i = 0; i < text.size();) {
        if (std::isspace(static_cast<unsigned char>(text[i]))) {
            ++i;
            continue;
        }
        if (const std::size_t end = behind_comment(text, i); end != i) {
            i = end;
            continue;
        }
        std::size_t end = i + 1;
        if (is_word(text[i]) || text[i] == '.')
            while (end < text.size() && (is_word(text[end]) || (!is_letter(text[i]) && text[end] == '.'))) ++end;
        const std::string_view token = text.substr(i, end - i);
        if (is_letter(text[i]) && std::ranges::count(own_words, token) == 0)
            tokens += 'v' + std::to_string(names.try_emplace(token, names.size()).first->second);
        else
            tokens += token;
        tokens += ' ';
        ++print.tokens;
        i = end;
    }
    print.hash = sha256(tokens);
    return print;
}

}  // namespace grade::course
