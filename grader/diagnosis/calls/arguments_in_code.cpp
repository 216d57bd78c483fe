#include "diagnosis/calls/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace grade {

namespace {

std::string number_in_code(double x) {
    if (std::isnan(x)) return "NAN";
    if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
    return fmt::format("{}", x == 0 ? 0.0 : x);
}

/// "Color(0.2, 0.5, 1)"
std::string value_in_code(const Field& part, const Row& row) {
    if (part.kind == Kind::flag) return row[part.at] != 0 ? "true" : "false";
    if (part.kind == Kind::choice) return choice_type(part) + "::" + value_in_words(part, row);
    std::string text = number_in_code(row[part.at]);
    if (size_of(part.kind) == 1) return text;
    for (std::size_t k = 1; k < size_of(part.kind); ++k) text += ", " + number_in_code(row[part.at + k]);
    return fmt::format("{}({})",
                       part.kind == Kind::color        ? "Color"
                       : part.kind == Kind::vector     ? "vec3"
                       : part.kind == Kind::whole_pair ? "ivec2"
                                                       : "vec2",
                       text);
}

/// "const std::vector<Color> radiance{Color(1, 1, 1)};"
std::string list_in_code(const List& list, const Row& row) {
    std::string values, numbers;
    std::size_t at = list.at + 1;
    for (std::size_t k = 0; k < list.count; ++k) {
        const char* comma = k ? ", " : "";
        if (list.stride > 0) {
            values += comma + value_in_code({"", list.stride == 3 ? Kind::color : Kind::number, at}, row);
            at += list.stride;
            continue;
        }
        values += fmt::format("{}{{{}, {}, u[{}]}}", comma, number_in_code(row[at]), number_in_code(row[at + 1]), k);
        const std::size_t count = std::size_t(row[at + 2]);
        numbers += fmt::format("{}{{", comma);
        for (std::size_t i = 0; i < count; ++i) numbers += (i ? ", " : "") + number_in_code(row[at + 3 + i]);
        numbers += "}";
        at += 3 + count;
    }
    const char* type = list.stride == 3 ? "Color" : list.stride > 0 ? "Real" : "Stratum";
    const std::string own = fmt::format("const std::vector<{}> {}{{{}}};\n", type, list.name, values);
    return list.stride > 0 ? own : fmt::format("const std::vector<std::vector<Real>> u{{{}}};\n", numbers) + own;
}

}  // namespace

std::string call_in_code(const Signature& signature, const Row& row) {
    constexpr std::size_t longest_list = 16;
    const Row defaults = signature.blank();
    const Layout layout = signature.of_arguments(row), plain = signature.of_arguments(defaults);
    std::string before, given;
    for (const Field& formula : layout.formulas)
        before += fmt::format("const Function {} = [](Real x) {{ return {}; }};\n", formula.name,
                              formula_in_words(row, formula.at, number_in_code));
    for (const List& list : layout.lists) {
        if (list.count > longest_list) return {};
        before += list_in_code(list, row);
    }
    for (const auto& [type, name] : signature.arguments) {
        const auto part = std::ranges::find(layout.parts, name, &Field::name);
        given += (given.empty() ? "" : ", ") + (part == layout.parts.end() ? name : value_in_code(*part, row));
        if (is_structure(type)) before += fmt::format("{} {}{{}};\n", type, name);
        for (std::size_t i = 0; i < layout.parts.size(); ++i) {
            const std::string value = value_in_code(layout.parts[i], row);
            if (layout.parts[i].name.starts_with(name + ".") && value != value_in_code(plain.parts[i], defaults))
                before += fmt::format("{} = {};\n", layout.parts[i].name, value);
        }
    }
    return fmt::format("{}{}({});\n", before, signature.fragment, given);
}

}  // namespace grade
