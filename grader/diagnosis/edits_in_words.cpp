#include "diagnosis/edits_in_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/expressions.h"

namespace grade {

namespace {

constexpr std::size_t longest = 100;  // text that is repeated

/// A student's text, as it can be printed.
std::string printable(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < ' ' || c > '~' || c == '`'; }, '?');
    return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

std::string change_in_words(const Expressions& all, const Mistake& change) {
    const textbook::Node& node = all.node(change.made.nodes.front());
    const bool is_everywhere = change.made.nodes.size() > 1;
    const std::string words =
        in_place(printable(changed_in_words(all, change)), printable(written_in_words(all, change)),
                 is_everywhere ? "" : which_in_words(all, change));
    if (is_everywhere) return words + " everywhere";
    const std::string where = fmt::format("{} in line {}", words, node.line);
    return node.context == node.text || node.context.size() > longest
               ? where
               : fmt::format("{}, `{}`", where, printable(node.context));
}

}  // namespace

int line_of(const Expressions& all, const Edit& edit) { return all.node(edit.first->made.nodes.front()).line; }

std::string in_words(const Expressions& all, const Edit& edit) {
    const std::string words = "with " + change_in_words(all, *edit.first);
    return edit.second ? words + ", and " + change_in_words(all, *edit.second) : words;
}

}  // namespace grade
