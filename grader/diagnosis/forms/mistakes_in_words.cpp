#include <cstdlib>

#include "diagnosis/calls/expressions.h"
#include "diagnosis/calls/scalars.h"
#include "diagnosis/forms/mistakes.h"
#include "textbook/functions.h"
#include "textbook/operators.h"

namespace grade {

using textbook::Made;

namespace {

bool is_number(std::string_view text) {
    return !text.empty() && std::string_view("0123456789.").find(text.front()) != text.npos &&
           text.find_first_not_of("0123456789.eE+-f") == text.npos;
}

/// "cos" of "cos(x)"
std::string called(std::string_view call) { return std::string(call.substr(0, call.find('('))); }

/// As C++ has a number of the same type: "0.0" for 0 in the place of "0.5".
std::string of_type(const std::string& written, double x) {
    const std::string words = number_in_words(x);
    const bool is_whole = words.find_first_not_of("0123456789-") == words.npos;
    return is_whole && written.find_first_of(".e") != written.npos ? words + ".0" : words;
}

/// Of a mistake in a literal, the number that takes its place.
std::string other_number(const textbook::Node& node, const Mistake& mistake) {
    const double x = std::strtod(node.text.c_str(), nullptr);
    const std::size_t f = mistake.made.function;
    switch (mistake.made.made) {
        case Made::number:
            return of_type(node.text, scalar_functions[f].value(x));
        case Made::tolerance:
            return of_type(node.text, tolerance_functions[f].value(x));
        case Made::share:
            return of_type(node.text, share_functions[f].value(x));
        case Made::limit:
            return of_type(node.text, limit_functions[f].value(x));
        default:
            return filled(mistake.pattern, node.name);
    }
}

/// Whether nothing beside it binds it: all of a statement, an argument, what is in brackets.
bool stands_alone(const std::string& text, const std::string& context) {
    const std::size_t at = context.find(text);
    if (at == context.npos) return false;
    const std::string before = context.substr(0, at), after = context.substr(at + text.size());
    const auto ends = [&](const char* end) { return before.ends_with(end); };
    const bool is_first = before.empty() || ends("(") || ends(", ") || ends("= ") || ends("return ");
    return is_first && (after.empty() || after.starts_with(")") || after.starts_with(","));
}

/// "x" for "1 * x", and "1" for "x / x": what another operator makes of an expression.
std::string simpler(const std::string& text) {
    if (text.starts_with("1 * ")) return text.substr(4);
    const std::size_t over = text.find(" / ");
    const bool are_same = over != text.npos && text.substr(0, over) == text.substr(over + 3);
    return are_same ? "1" : text;
}

/// Another operator binds less than what is written: within a larger expression it needs brackets.
std::string in_its_place(const textbook::Node& node, const std::string& alternative) {
    const bool is_whole = stands_alone(node.text, node.context);
    const bool is_looser = textbook::loosest(alternative) < textbook::loosest(node.text);
    return is_looser && !is_whole ? "(" + alternative + ")" : alternative;
}

}  // namespace

std::string changed_in_words(const Expressions& all, const Mistake& mistake) {
    const textbook::Node& node = all.node(mistake.made.nodes.front());
    if (mistake.made.alternative != 0)
        return mistake.made.nodes.size() > 1 ? called(mistake.pattern) : in_its_place(node, simpler(mistake.pattern));
    const bool is_sign_too_many = mistake.pattern == "-{}" && node.name.starts_with('-');
    if (is_sign_too_many && node.name.find(' ') == node.name.npos) return node.name.substr(1);
    if (!mistake.other.empty()) return filled(mistake.pattern, node.name, mistake.other);
    return is_number(node.text) ? other_number(node, mistake) : filled(mistake.pattern, node.name);
}

std::string written_in_words(const Expressions& all, const Mistake& mistake) {
    const textbook::Node& node = all.node(mistake.made.nodes.front());
    if (mistake.made.alternative == 0) return node.name;
    return mistake.made.nodes.size() > 1 ? called(node.text) : node.text;
}

std::string which_in_words(const Expressions& all, const Mistake& mistake, bool in_statement) {
    static constexpr const char* ordinals[] = {"the first ", "the second ", "the third ", "the fourth "};
    const textbook::Node& node = all.node(mistake.made.nodes.front());
    std::size_t alike = 0, before = 0;
    for (const textbook::Node& other : all.nodes)
        if (other.text == node.text && other.name == node.name && (!in_statement || other.context == node.context) &&
            other.line == node.line && other.function == node.function) {
            if (&other < &node) ++before;
            ++alike;
        }
    return alike > 1 && before < std::size(ordinals) ? ordinals[before] : "";
}

}  // namespace grade
