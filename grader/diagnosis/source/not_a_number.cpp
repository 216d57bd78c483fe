#include "diagnosis/source/not_a_number.h"

#include <fmt/format.h>

#include <cmath>

#include "diagnosis/source/edits_in_words.h"
#include "textbook/edits.h"

namespace grade {

namespace {

double mark_of(double seen) { return seen - std::floor(seen); }

/// The node that is nan though nothing is that it is made of; none: there is none.
std::optional<std::size_t> first_in(const Row& seen, const std::vector<textbook::Node>& nodes) {
    const auto is_nan = [&](std::size_t i) { return mark_of(seen[i]) == textbook::mark_of_nan; };
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (is_nan(i) && std::ranges::none_of(nodes[i].parts, [&](int part) { return is_nan(std::size_t(part)); }))
            return i;
    return std::nullopt;
}

/// "`f` is infinite and `v` is 0", of what a node is made of in all of these calls.
std::string parts_in_words(const textbook::Node& node, const std::vector<textbook::Node>& nodes, const Rows& seen) {
    std::string all;
    for (const int part : node.parts)
        for (const auto& [mark, words] :
             {std::pair(textbook::mark_of_infinity, "infinite"), std::pair(textbook::mark_of_zero, "0")}) {
            const auto is_so = [part, mark = mark](const Row& row) { return mark_of(row[std::size_t(part)]) == mark; };
            if (std::ranges::all_of(seen, is_so))
                all += fmt::format("{}`{}` is {}", all.empty() ? "" : " and ", printable(nodes[std::size_t(part)].name),
                                   words);
        }
    return all;
}

/// Why a function of a number that is none of these has no value.
std::string outside_in_words(const std::string& call) {
    if (call.starts_with("sqrt(")) return ", the root of a negative number";
    if (call.starts_with("log(")) return ", the logarithm of a negative number";
    return call.starts_with("acos(") || call.starts_with("asin(") ? ", of a number beyond -1 to 1" : "";
}

}  // namespace

std::string first_not_a_number(const Calls& calls, const Editable& source) {
    constexpr std::size_t most = 48;
    Rows rows;
    for (std::size_t k = 0; k < calls.size() && rows.size() < most; ++k)
        if (is_nan(calls.mine[k], calls.right[k]))
            rows.push_back(textbook::row_of({source.nodes.size(), true, {}, calls.rows[k]}));
    std::vector<Rows> seen(source.nodes.size());  // by the node that is the first
    for (Row& row : source.ask(rows)) {
        if (row.size() != source.nodes.size()) return {};
        if (const auto first = first_in(row, source.nodes)) seen[*first].push_back(std::move(row));
    }
    const auto most_often = std::ranges::max_element(seen, {}, &Rows::size);
    if (most_often == seen.end() || 2 * most_often->size() <= rows.size()) return {};
    const textbook::Node& node = source.nodes[std::size_t(most_often - seen.begin())];
    const std::string parts = parts_in_words(node, source.nodes, *most_often);
    return fmt::format("`{}` in line {}{}", printable(node.text), node.line,
                       parts.empty() ? outside_in_words(node.text) : ", where " + parts);
}

}  // namespace grade
