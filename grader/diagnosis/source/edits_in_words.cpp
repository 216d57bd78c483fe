#include "diagnosis/source/edits_in_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/calls/expressions.h"
#include "diagnosis/forms/whole_expression.h"
#include "diagnosis/source/renamed.h"

namespace grade {

namespace {

constexpr std::size_t longest = 100;  // text that is repeated

/// "vec3(0, 0, 1)" for "(0, 0, 1)", as it can be compiled.
std::string with_type(const std::string& text) {
    if (!text.starts_with('(') || !text.ends_with(')')) return text;
    int depth = 0, commas = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += (text[i] == '(') - (text[i] == ')');
        commas += depth == 1 && text[i] == ',';
        if (depth == 0 && i + 1 < text.size()) return text;
    }
    return commas == 1 ? "vec2" + text : commas == 2 ? "vec3" + text : text;
}

/// Of what a variable is set to, the whole statement, as it can be written: "`y = 2 * x` in place of `y = x`"; empty:
/// the node is none, or long.
std::string setting_in_words(const Expressions& all, const Mistake& change) {
    const std::size_t at = std::size_t(change.made.nodes.front() - all.first);
    const std::string& name = all.nodes[at].name;
    const std::string& text = all.nodes[at].text;
    if (name == text || all.nodes[at].context != name + " = " + text || text.size() > longest) return {};
    std::vector<textbook::Node> nodes(all.nodes.begin(), all.nodes.end());
    nodes[at].name = text;
    const std::string changed = changed_in_words({nodes, all.first}, change);
    return in_place(name + " = " + printable(with_type(changed)), name + " = " + printable(text));
}

std::string change_in_words(const Expressions& all, const Mistake& change) {
    const int first = change.made.nodes.front();
    const bool is_everywhere = change.made.nodes.size() > 1;
    if (const auto whole = of_whole(all, change)) return change_in_words(all, *whole);
    const textbook::Node& node = all.node(first);
    if (const std::string words = is_everywhere ? "" : setting_in_words(all, change); !words.empty())
        return fmt::format("{} in line {}", words, node.line);
    constexpr double mostly = 0.6;  // of the statement
    const bool is_told =
        double(node.text.size()) > mostly * double(node.context.size()) || node.context.size() > longest;
    const std::string words =
        in_place(printable(with_type(changed_in_words(all, change))), printable(written_in_words(all, change)),
                 is_everywhere ? "" : which_in_words(all, change, !is_told));
    if (is_everywhere) {
        const bool in_one_line =
            std::ranges::all_of(change.made.nodes, [&](int other) { return all.node(other).line == node.line; });
        return fmt::format("{} everywhere{} in line {}", words, in_one_line ? "" : ", first", node.line);
    }
    const std::string where = fmt::format("{} in line {}", words, node.line);
    return is_told ? where : fmt::format("{}, `{}`", where, printable(node.context));
}

}  // namespace

std::string printable(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < ' ' || c > '~' || c == '`'; }, '?');
    return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

int line_of(const Expressions& all, const Edit& edit) { return all.node(edit.first->made.nodes.front()).line; }

std::string in_words(const Expressions& all, const Edit& edit) {
    const bool is_one = edit.in_one_expression;
    const std::string words = "with " + change_in_words(all, is_one ? of_both(all, edit) : *edit.first);
    return edit.second && !is_one ? words + ", and " + change_in_words(all, *edit.second) : words;
}

}  // namespace grade
