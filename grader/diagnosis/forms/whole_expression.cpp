#include "diagnosis/forms/whole_expression.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "diagnosis/calls/expressions.h"
#include "textbook/operators.h"

namespace grade {

namespace {

bool is_whole_number(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c); });
}

/// "a : b" of a choice, of which the condition is known.
std::string chosen_of(const std::string& both, const std::string& condition) {
    const std::size_t colon = both.find(" : ");
    if (colon == both.npos || both.find(" ? ") != both.npos) return {};
    return condition == "true" ? both.substr(0, colon) : condition == "false" ? both.substr(colon + 3) : "";
}

/// A sum, product or condition, of which one operand has changed.
struct Operands {
    std::string written, changed, sign, other;
    bool is_last;  // the one that has changed

    std::string simplest() const {
        const bool is_product = sign == "*" || (sign == "/" && is_last), is_rest = sign == "-",
                   is_sum = sign == "+" || (is_rest && is_last);
        const bool is_zero = changed == "0" || changed == "(0, 0, 0)";
        if (is_zero && (sign == "*" || (sign == "/" && !is_last))) return changed;
        if ((is_product && changed == "1") || (is_sum && is_zero)) return other;
        if (sign == "/" && !is_last && is_whole_number(changed)) return changed + " / " + other;
        if ((sign == "&&" && changed == "true") || (sign == "||" && changed == "false")) return other;
        if (is_rest && is_zero) return "-" + bracketed(other);
        if (is_sum && is_last && changed == "-" + written) return other + (is_rest ? " + " : " - ") + written;
        if (!is_whole_number(written) || !is_whole_number(changed)) return {};
        return is_last ? other + " " + sign + " " + changed : changed + " " + sign + " " + other;
    }
};

std::string replaced_in(const std::string& whole, const std::string& written, const std::string& changed) {
    const auto is_operator = [](const std::string& sign) { return textbook::operators().contains(sign); };
    if (whole.starts_with(written + " ? ")) return chosen_of(whole.substr(written.size() + 3), changed);
    if (whole.starts_with(written + " ")) {
        const std::string rest = whole.substr(written.size() + 1), sign = rest.substr(0, rest.find(' '));
        if (is_operator(sign) && rest.size() > sign.size() + 1)
            return Operands{written, changed, sign, rest.substr(sign.size() + 1), false}.simplest();
    }
    if (!whole.ends_with(" " + written)) return {};
    const std::string before = whole.substr(0, whole.size() - written.size() - 1);
    const std::size_t at = before.rfind(' ');
    if (at == before.npos || at == 0 || !is_operator(before.substr(at + 1))) return {};
    return Operands{written, changed, before.substr(at + 1), before.substr(0, at), true}.simplest();
}

}  // namespace

std::optional<Mistake> of_whole(const Expressions& all, const Mistake& change) {
    if (change.made.nodes.size() != 1 || change.made.alternative != 0) return std::nullopt;
    const int node = change.made.nodes.front();
    const auto whole = std::ranges::find_if(
        all.nodes, [&](const textbook::Node& other) { return std::ranges::count(other.parts, node) > 0; });
    if (whole == all.nodes.end()) return std::nullopt;
    const std::string by = replaced_in(whole->text, all.node(node).text, changed_in_words(all, change));
    if (by.empty()) return std::nullopt;
    Mistake of_whole{by};
    of_whole.made.nodes = {all.first + int(std::distance(all.nodes.begin(), whole))};
    of_whole.made.alternative = 1;  // its text is told as it stands
    return of_whole;
}

}  // namespace grade
