#include "textbook/in_double.h"

#include <set>
#include <string_view>

#include "textbook/tokens.h"

namespace grade::textbook {

namespace {

/// "sqrt" of "sqrtf".
bool is_function_of_float(std::string_view name) {
    static const std::set<std::string_view> all{"sqrtf", "sinf",   "cosf",   "tanf",  "asinf",  "acosf",
                                                "atanf", "atan2f", "expf",   "logf",  "powf",   "fabsf",
                                                "fminf", "fmaxf",  "floorf", "ceilf", "roundf", "hypotf"};
    constexpr std::string_view standard = "std::";
    if (name.starts_with(standard)) name.remove_prefix(standard.size());
    return all.contains(name);
}

/// "0.5" of "0.5f"; not 0xf.
bool is_constant_of_float(const Token& token) {
    const char last = token.text.back();
    return token.kind == Token::Kind::number && (last == 'f' || last == 'F') && !token.text.starts_with("0x");
}

std::string widened(const Token& token) {
    if (is_constant_of_float(token) || (token.kind == Token::Kind::name && is_function_of_float(token.text)))
        return token.text.substr(0, token.text.size() - 1);
    if (token.kind != Token::Kind::name) return token.text;
    if (token.text == "float") return "double";
    // in the namespace rt, vec3 has doubles
    for (const std::string_view vector : {"vec2", "vec3"})
        if (token.text == "glm::" + std::string(vector)) return "glm::d" + std::string(vector);
    return token.text;
}

}  // namespace

std::optional<Widened> in_double(const std::string& text) {
    Widened all{"", 0};
    std::size_t copied = 0;
    for (const Token& token : tokens_of(text)) {
        const std::string other = token.kind == Token::Kind::end ? token.text : widened(token);
        if (other == token.text) continue;
        all.text += text.substr(copied, token.from - copied) + other, copied = token.to;
        if (all.line == 0) all.line = token.line;
    }
    all.text += text.substr(copied);
    return all.line > 0 ? std::optional(all) : std::nullopt;
}

namespace {

/// "0.5", "1e-3"
bool is_real(const Token& token) {
    return token.kind == Token::Kind::number && token.text.find_first_of(".eE") != std::string::npos;
}

bool is_declared_whole(const std::vector<Token>& tokens, std::size_t i) {
    const bool is_type = tokens[i].text == "int" || tokens[i].text == "long";
    const std::string before = i > 0 ? tokens[i - 1].text : ";";
    const bool is_first = before == ";" || before == "{" || before == "}" || before == "const";
    return is_type && is_first && tokens[i + 1].kind == Token::Kind::name && tokens[i + 2].text == "=";
}

}  // namespace

std::vector<Widened> with_reals(const std::string& text) {
    constexpr std::size_t most = 6;
    const std::vector<Token> tokens = tokens_of(text);
    Widened together{"", 0};
    std::size_t copied = 0;
    std::vector<Widened> all;
    for (std::size_t i = 0; tokens[i].kind != Token::Kind::end && all.size() < most; ++i) {
        const Token& token = tokens[i];
        const bool is_quotient = token.text == "/" && i > 0 && !is_real(tokens[i - 1]) && !is_real(tokens[i + 1]);
        if (!is_quotient && !is_declared_whole(tokens, i)) continue;
        const std::string real = is_quotient ? "* 1.0 /" : "double";
        all.push_back({text.substr(0, token.from) + real + text.substr(token.to), token.line, is_quotient});
        if (together.line == 0) together.line = token.line, together.is_quotient = is_quotient;
        together.text += text.substr(copied, token.from - copied) + real, copied = token.to;
    }
    together.text += text.substr(copied);
    if (all.size() > 1) all.insert(all.begin(), together);
    return all;
}

}  // namespace grade::textbook
