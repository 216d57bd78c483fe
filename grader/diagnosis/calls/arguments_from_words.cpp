#include "diagnosis/calls/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "files/words.h"

namespace grade {

namespace {

/// At commas outside of brackets.
std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> list(1);
    int depth = 0;
    for (const char c : text) {
        depth += (c == '(' || c == '{') - (c == ')' || c == '}');
        if (c == ',' && depth == 0)
            list.emplace_back();
        else
            list.back() += c;
    }
    return list;
}

double number_from_words(const std::string& words) {
    const std::string text = trimmed(words);
    if (text == "true") return 1;
    if (text == "false") return 0;
    std::size_t used = 0;
    double x = 0;
    try {
        x = std::stod(text, &used);
    } catch (const std::logic_error&) {
        used = 0;
    }
    if (used == 0 || used != text.size()) throw std::invalid_argument(fmt::format("\"{}\" is no number", text));
    return x;
}

void set(const Field& part, const std::string& words, Row& row) {
    if (part.kind == Kind::choice) {
        const auto& names = choices_of(part);
        const auto found = std::ranges::find(names, words);
        if (found == names.end())
            throw std::invalid_argument(fmt::format("{}: \"{}\" is none of its values", part.name, words));
        row[part.at] = double(found - names.begin());
        return;
    }
    const bool bracket = !words.empty() && (words.front() == '(' || words.front() == '{');
    const auto numbers = bracket ? split(words.substr(1, words.size() - 2)) : std::vector{words};
    if (numbers.size() != size_of(part.kind))
        throw std::invalid_argument(
            fmt::format("{} is {} numbers; expected {}", part.name, numbers.size(), size_of(part.kind)));
    for (std::size_t k = 0; k < numbers.size(); ++k) row[part.at + k] = number_from_words(numbers[k]);
}

}  // namespace

bool are_readable(const Signature& signature) {
    const Layout layout = signature.of_arguments(signature.blank());
    return layout.lists.empty() && layout.formulas.empty();
}

Row arguments_from_words(const Signature& signature, const std::string& words) {
    Row row = signature.blank();
    const Layout layout = signature.of_arguments(row);
    if (!are_readable(signature))
        throw std::invalid_argument(
            fmt::format("{} takes functions or lists, which cannot be written here", signature.fragment));
    if (trimmed(words).empty()) return row;
    for (const std::string& one : split(words)) {
        const std::size_t equals = one.find('=');
        const std::string name = trimmed(one.substr(0, equals));
        const auto part = std::ranges::find(layout.parts, name, &Field::name);
        if (equals == one.npos || part == layout.parts.end()) {
            std::string names;
            for (const Field& known : layout.parts) names += (names.empty() ? "" : ", ") + known.name;
            throw std::invalid_argument(
                fmt::format("\"{}\": expected NAME = VALUE, where NAME is one of {}", trimmed(one), names));
        }
        set(*part, trimmed(one.substr(equals + 1)), row);
    }
    return row;
}

}  // namespace grade
