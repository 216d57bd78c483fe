#pragma once

#include <fmt/format.h>

#include <string>

/// Formulas in words.
namespace grade {

/// As an operand.
std::string bracketed(const std::string& name);

/// As a person writes it: "n + 1" for "(n + 2) - 1", "x" for "1 - (1 - x)", "length(u)" for "sqrt(dot(u, u))".
std::string simplified(const std::string& text);

template <class... Names>
std::string filled(std::string_view words, const Names&... names) {
    const bool is_alone = words.ends_with("({})") || words == "{1}";
    return simplified(fmt::format(fmt::runtime(words), (is_alone ? names : bracketed(names))...));
}

/// "`2 * x` in place of `x`", or "of the second `x`"
inline std::string in_place(const std::string& expression, const std::string& name, const std::string& which = "") {
    return fmt::format("`{}` in place of {}`{}`", expression, which, name);
}

}  // namespace grade
