#include "report/escape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace grade {

namespace {

/// Length of the UTF-8 sequence at the front of text; 0: there is none.
std::size_t sequence(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xc2 && first < 0xe0 ? 2
                               : first >= 0xe0 && first < 0xf0 ? 3
                               : first >= 0xf0 && first < 0xf5 ? 4
                                                               : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    // C1 controls, and marks that change the direction of the text around them
    if (length == 2 && first == 0xc2 && byte(1) < 0xa0) return 0;
    if (length == 3 && first == 0xe2 &&
        ((byte(1) == 0x80 && (byte(2) & 0xf0) == 0xa0 && byte(2) >= 0xa8) || (byte(1) == 0x81 && byte(2) >= 0xa6)))
        return 0;
    return length;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
    std::string clean;
    while (!text.empty()) {
        if (clean.size() >= most) return clean + "...";
        const std::size_t length = sequence(text);
        const char c = text.front();
        if (length == 0 || (static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t') || c == 127) {
            clean += c == '\r' ? "" : "?";
            text.remove_prefix(1);
        } else {
            // what GitHub's runner takes for a command of its own
            const bool begins_word =
                clean.empty() || clean.back() == ' ' || clean.back() == '\n' || clean.back() == '\t';
            const bool is_command = text.starts_with("##[") || (begins_word && text.starts_with("::"));
            clean += text.substr(0, length);
            if (is_command) clean += ' ';
            text.remove_prefix(length);
        }
    }
    return clean;
}

std::string printable_line(std::string_view text, std::size_t most) {
    std::string clean = printable(text, most);
    std::ranges::replace_if(
        clean, [](char c) { return c == '\n' || c == '\t'; }, '?');
    return clean;
}

std::string html(std::string_view text) {
    constexpr std::string_view special = "&<>\"'";
    constexpr std::string_view entities[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
    std::string safe;
    for (const char c : printable(text, 100'000))
        if (const auto at = special.find(c); at == special.npos)
            safe += c;
        else
            safe += entities[at];
    return safe;
}

std::string with_powers(std::string_view safe, std::string_view open, std::string_view close) {
    constexpr std::string_view digits = "0123456789", square_metres = "[m2]";
    constexpr std::size_t longest_power = 12;
    std::string raised;
    for (std::size_t i = 0; i < safe.size(); ++i) {
        const bool has_base = i > 0 && (std::isalnum(static_cast<unsigned char>(safe[i - 1])) || safe[i - 1] == ')');
        const std::size_t first = i + 1 + safe.substr(i + 1).starts_with('-');
        if (safe.substr(i).starts_with(square_metres)) {
            raised += fmt::format("[m{}2{}]", open, close);
            i += square_metres.size() - 1;
        } else if (const std::size_t close_at = safe.find(')', i);
                   has_base && safe.substr(i).starts_with("^(") && close_at - i < longest_power) {
            raised += fmt::format("{}{}{}", open, safe.substr(i + 2, close_at - i - 2), close);
            i = close_at;
        } else if (safe[i] == '^' && has_base && first < safe.size() && digits.find(safe[first]) != digits.npos) {
            std::size_t end = std::min(safe.find_first_not_of("0123456789./", first), safe.size());
            while (digits.find(safe[end - 1]) == digits.npos) --end;  // the end of a sentence
            raised += fmt::format("{}{}{}", open, safe.substr(i + 1, end - i - 1), close);
            i = end - 1;
        } else {
            raised += safe[i];
        }
    }
    return raised;
}

std::string html_with_code(std::string_view text) {
    const std::string safe = html(text);
    std::string marked;
    std::size_t at = 0;
    for (std::size_t open = 0; (open = safe.find('`', at)) != safe.npos;) {
        const std::size_t close = safe.find('`', open + 1);
        if (close == safe.npos) break;
        marked += with_powers(std::string_view(safe).substr(at, open - at)) + "<code>" +
                  safe.substr(open + 1, close - open - 1) + "</code>";
        at = close + 1;
    }
    return marked + with_powers(std::string_view(safe).substr(at));
}

}  // namespace grade
