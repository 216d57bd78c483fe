#include "submission/source_fault.h"

#include <fmt/format.h>

#include <algorithm>

#include "files/source_text.h"
#include "files/words.h"
#include "rt/files/words.h"

namespace grade {

namespace {

struct SourceFault {
    std::size_t at;
    std::string wrong, expected;
};

bool is_wide(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
    const std::string_view head = text.substr(0, 200);
    return head.size() >= 8 && std::count(head.begin(), head.end(), '\0') > std::ptrdiff_t(head.size()) / 3;
}

/// What a file starts with that is no C++.
SourceFault start_of(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == text.npos) return {text.npos, {}, {}};
    const std::string head = lower(text.substr(first, 16));
    const auto starts = [&](const char* with) { return head.starts_with(with); };
    const char* source = "the fragment's C++ source";
    if (starts("<!doctype") || starts("<html") || starts("<?xml")) return {first, "this is a web page", source};
    if (starts("{\\rtf")) return {first, "this is a document of a word processor (RTF)", "plain text"};
    if (starts("%pdf") || starts("pk\x03\x04") ||
        starts("\x7f"
               "elf") ||
        starts("\xd0\xcf\x11\xe0"))
        return {first, "this is no text file", source};
    if (starts("```")) {
        const std::string_view line = text.substr(first, text.find_first_of("\r\n", first) - first);
        return {first, "this is Markdown: the line " + rt::in_quotes(line) + " is no C++", "C++ alone"};
    }
    if (starts("diff --git") || starts("--- a/")) return {first, "this is a patch, not the patched file", source};
    return {text.npos, {}, {}};
}

/// Lines that git writes around the two sides of a merge.
SourceFault conflict_in(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view line = text.substr(at, std::min(text.find_first_of("\r\n", at), text.size()) - at);
        for (const char* marker : {"<<<<<<<", ">>>>>>>"})
            if (line.starts_with(marker) && (line.size() == 7 || line[7] == ' '))
                return {at,
                        fmt::format("a merge conflict is not resolved: git has left the line {}", rt::in_quotes(line)),
                        "one of the two versions, without the lines <<<<<<<, ======= and >>>>>>>"};
        at += line.size() + 1;
    }
    return {text.npos, {}, {}};
}

/// The comment that has no end.
SourceFault open_comment_in(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "//") {
            do i = std::min(text.find('\n', i + 1), text.size());
            while (i < text.size() && (text[i - 1] == '\\' || text.substr(i - 2, 2) == "\\\r"));
        } else if (text.substr(i, 2) == "/*") {
            const std::size_t end = text.find("*/", i + 2);
            if (end == text.npos) return {i, "the comment that starts here has no end", "*/"};
            i = end + 2;
        } else if (text.substr(i, 2) == "R\"" && (i == 0 || !is_word(text[i - 1]))) {
            const std::size_t open = text.find('(', i);
            if (open == text.npos) break;
            const std::string close = fmt::format("){}\"", text.substr(i + 2, open - i - 2));
            const std::size_t end = text.find(close, open);
            i = end == text.npos ? text.size() : end + close.size();
        } else {
            i = std::max(behind_quoted(text, i), i + 1);
        }
    }
    return {text.npos, {}, {}};
}

}  // namespace

std::string source_fault(std::string_view text, const std::string& shown) {
    const auto said = [&](const SourceFault& fault) {
        return fmt::format("{}:{}: error: {}; expected {}\n", shown, line_and_column(text, fault.at), fault.wrong,
                           fault.expected);
    };
    if (is_wide(text))
        return said({0, "the file is UTF-16 text, which no compiler reads", "UTF-8: save it again as such"});
    for (const SourceFault& fault : {start_of(text), conflict_in(text), open_comment_in(text)})
        if (fault.at != text.npos) return said(fault);
    if (const std::size_t nul = text.find('\0'); nul != text.npos)
        return said({nul, "there is a byte 0 in the file", "text"});
    return {};
}

}  // namespace grade
