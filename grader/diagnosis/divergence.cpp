#include "diagnosis/divergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "files/words.h"

namespace grade {

namespace {

constexpr std::size_t most_lines = 12, most_in_line = 160;

/// A number at the start of the text, which is taken from it.
std::optional<double> take_number(std::string_view& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(std::size_t(end - text.data()));
    return value;
}

/// Whether two numbers differ by more than the digits that a trace shows.
bool apart(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return false;
    return !std::isfinite(a) || !std::isfinite(b) ||
           std::abs(a - b) > std::max(1e-4 * std::max(std::abs(a), std::abs(b)), 1e-7);
}

bool is_same_line(std::string_view a, std::string_view b) {
    const auto begins_number = [](std::string_view text, char before) {
        return !text.empty() && std::strchr("-0123456789in", text[0]) &&
               !std::isalnum(static_cast<unsigned char>(before));
    };
    for (char before = ' '; !a.empty() && !b.empty();) {
        if (begins_number(a, before) && begins_number(b, before)) {
            std::string_view rest_a = a, rest_b = b;
            const auto x = take_number(rest_a), y = take_number(rest_b);
            if (x && y) {
                if (apart(*x, *y)) return false;
                a = rest_a, b = rest_b, before = '0';
                continue;
            }
        }
        if (a[0] != b[0]) return false;
        before = a[0];
        a.remove_prefix(1), b.remove_prefix(1);
    }
    return a.empty() && b.empty();
}

/// As it can be shown: a student's program may have written it.
std::string shown(std::string_view line) {
    std::string text(line.substr(0, most_in_line));
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 32 || c > 126; }, '?');
    return text;
}

}  // namespace

std::string first_divergence(std::string_view mine, std::string_view right) {
    const auto a = lines_of(mine), b = lines_of(right);
    std::size_t at = 0;
    while (at < a.size() && at < b.size() && is_same_line(a[at], b[at])) ++at;
    if (at >= b.size() || at >= a.size()) return {};
    std::size_t begin = at;
    while (begin > 0 && !b[begin].starts_with("sample")) --begin;
    std::string text;
    for (std::size_t i = begin; i < at; ++i) {
        if (i > begin && i + most_lines == at) text += "  ...\n";
        if (i == begin || i + most_lines >= at) text += shown(b[i]) + '\n';
    }
    return text + fmt::format("yours:\n{}\nthe solution's:\n{}\n", shown(a[at]), shown(b[at]));
}

}  // namespace grade
