#include "diagnosis/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include "protocol/rows.h"

namespace grade {

namespace {

struct Structure {
    std::vector<Signature::Argument> fields;
    Row defaults;
};

const std::vector<std::string>& choices(const std::string& type) {
    static const std::map<std::string, std::vector<std::string>> all = {
        {"Emitter::Kind", {"quad", "disc", "sphere"}}, {"Event", {"camera", "diffuse", "specular", "lobe", "medium"}}};
    static const std::vector<std::string> none;
    const auto found = all.find(type);
    return found == all.end() ? none : found->second;
}

std::string without(std::string text, const std::string& word) {
    for (std::size_t at; (at = text.find(word)) != text.npos;) text.erase(at, word.size());
    return text;
}

/// "const Camera& camera, vec2 film"
std::vector<Signature::Argument> declared(const std::string& text) {
    std::vector<Signature::Argument> list;
    std::istringstream in(text);
    for (std::string one; std::getline(in, one, ',');) {
        one = without(without(one, "const "), "&");
        one.erase(0, one.find_first_not_of(' '));
        const std::size_t space = one.rfind(' ');
        if (space == one.npos) continue;
        list.push_back({one.substr(0, space), one.substr(space + 1)});
    }
    return list;
}

/// The types of rows.h, in its order.
const std::map<std::string, Structure>& structures() {
    const auto entry = [](const char* fields, Row defaults) {
        return Structure{declared(fields), std::move(defaults)};
    };
    static const std::map<std::string, Structure> all = {
        {"Ray", entry("vec3 origin, vec3 direction, Real near, Real far", row(rt::Ray{}))},
        {"Hit", entry("vec3 point, vec3 normal, Real error", row(rt::Hit{}))},
        {"Sphere", entry("vec3 center, Real radius", row(rt::Sphere{}))},
        {"Triangle", entry("vec3 a, vec3 b, vec3 c", row(rt::Triangle{}))},
        {"Quad", entry("vec3 center, vec3 u, vec3 v", row(rt::Quad{}))},
        {"Disc", entry("vec3 center, vec3 normal, Real radius", row(rt::Disc{}))},
        {"Camera",
         entry("vec3 eye, vec3 right, vec3 up, vec3 back, Real tan_half_fov, ivec2 size, Real lens_radius, Real focus",
               row(rt::Camera{}))},
        {"Shutter", entry("Real open, Real close", row(rt::Shutter{}))},
        {"Extent", entry("vec2 low, vec2 high", row(rt::Extent{}))},
        {"PointLight", entry("vec3 position, Color intensity, bool directional", row(rt::PointLight{}))},
        {"Emitter",
         entry("Emitter::Kind kind, Quad quad, Disc disc, Sphere sphere, Color radiance", row(rt::Emitter{}))},
        {"Material",
         entry("Color ambient, Color albedo, Color specular, Real shininess, Color reflectance, Color transmittance, "
               "Real exponent, Real ior, Color emission, bool sampled, Real medium.extinction, Color medium.albedo, "
               "Real medium.g",
               row(rt::Material{}))},
        {"LightSample", entry("vec3 direction, Real distance, Real density", row(rt::LightSample{}))},
        {"DiskSample", entry("vec2 point, Real density", row(rt::DiskSample{}))},
        {"DirectionSample", entry("vec3 direction, Real density", row(rt::DirectionSample{}))},
        {"FilmSample", entry("vec2 position, Real weight", row(rt::FilmSample{}))},
        {"Scattered", entry("vec3 direction, Color weight", row(rt::Scattered{}))},
        {"Outgoing", entry("Color local, Color mirror, Color glass", row(rt::Outgoing{}))}};
    return all;
}

std::optional<Kind> kind_of(const std::string& type) {
    static const std::map<std::string, Kind> all = {
        {"Real", Kind::number},          {"int", Kind::whole},   {"bool", Kind::flag},   {"Event", Kind::choice},
        {"Emitter::Kind", Kind::choice}, {"vec3", Kind::vector}, {"Color", Kind::color}, {"vec2", Kind::pair},
        {"ivec2", Kind::whole_pair}};
    const auto found = all.find(type);
    return found == all.end() ? std::nullopt : std::optional(found->second);
}

/// Elements of a list, and a function's parameters, end at the place that is returned.
std::size_t add_list(const Signature::Argument& argument, const Row& row, std::size_t at, Layout& layout) {
    if (argument.type == "Function") {
        layout.formulas.push_back({argument.name, Kind::number, at});
        return at + 2 + std::size_t(row.at(at + 1));
    }
    const std::size_t count = std::size_t(row.at(at));
    const bool strata = argument.type.find("Stratum") != std::string::npos;
    const std::size_t stride = strata ? 0 : argument.type.find("Color") != std::string::npos ? 3 : 1;
    layout.lists.push_back({argument.name, at, count, stride});
    std::size_t end = at + 1 + stride * count;
    for (std::size_t i = 0; strata && i < count; ++i) end += 3 + std::size_t(row.at(end + 2));
    return end;
}

std::size_t add(const Signature::Argument& argument, const std::string& name, const Row& row, std::size_t at,
                Layout& layout) {
    if (const auto kind = kind_of(argument.type)) {
        layout.parts.push_back({name, *kind, at});
        return at + size_of(*kind);
    }
    const auto found = structures().find(argument.type);
    if (found == structures().end()) return add_list(argument, row, at, layout);
    for (const auto& field : found->second.fields)
        at = add(field, name.empty() ? field.name : name + "." + field.name, row, at, layout);
    return at;
}

std::string choice_type(const Field& part) { return part.name.ends_with("kind") ? "Emitter::Kind" : "Event"; }

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == text.npos ? "" : text.substr(first, last - first + 1);
}

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
        const auto& names = choices(choice_type(part));
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

std::size_t size_of(Kind kind) {
    switch (kind) {
        case Kind::vector:
        case Kind::color:
            return 3;
        case Kind::pair:
        case Kind::whole_pair:
            return 2;
        default:
            return 1;
    }
}

Layout Signature::of_arguments(const Row& row) const {
    Layout layout;
    std::size_t at = 0;
    for (const Argument& argument : arguments) at = add(argument, argument.name, row, at, layout);
    if (at > row.size()) throw std::out_of_range("the row is too short");
    return layout;
}

Layout Signature::of_result(const Row& row) const {
    Layout layout;
    if (add({result, ""}, "", row, 0, layout) > row.size()) throw std::out_of_range("the row is too short");
    return layout;
}

Row Signature::blank() const {
    Row all;
    for (const Argument& argument : arguments) {
        if (const auto found = structures().find(argument.type); found != structures().end())
            all.insert(all.end(), found->second.defaults.begin(), found->second.defaults.end());
        else if (const auto kind = kind_of(argument.type))
            all.resize(all.size() + size_of(*kind));
        else
            all.resize(all.size() + (argument.type == "Function" ? 2 : 1));
    }
    return all;
}

std::optional<Signature> signature_of(const std::string& fragment, const std::string& header) {
    std::istringstream lines(header);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(" " + fragment + "(");
        if (at == line.npos || line.front() == '/' || line.front() == ' ' || !line.ends_with(");")) continue;
        const std::size_t open = line.find('(', at);
        return Signature{fragment, line.substr(0, at), declared(line.substr(open + 1, line.size() - open - 3))};
    }
    return std::nullopt;
}

std::string number_in_words(double x, int digits) {
    if (std::isnan(x)) return "nan";
    // of what is nearly a whole number, say, more digits: 1 - 2^-30 is not 1
    const double shown = digits > 0 ? std::stod(fmt::format("{:.2g}", x)) : x;
    if (std::isfinite(x) && digits < 10 && std::abs(x - shown) > 1e-12 * std::abs(x) &&
        fmt::format("{:.{}g}", x, digits) == fmt::format("{:.{}g}", shown, digits))
        digits = 10;
    return digits > 0 ? fmt::format("{:.{}g}", x == 0 ? 0.0 : x, digits) : fmt::format("{}", x == 0 ? 0.0 : x);
}

std::string value_in_words(const Field& part, const Row& row, int digits) {
    if (part.kind == Kind::flag) return row[part.at] != 0 ? "true" : "false";
    if (part.kind == Kind::choice) {
        const auto& names = choices(choice_type(part));
        return row[part.at] < double(names.size()) ? names[std::size_t(row[part.at])] : number_in_words(row[part.at]);
    }
    std::string text = number_in_words(row[part.at], digits);
    if (size_of(part.kind) == 1) return text;
    for (std::size_t k = 1; k < size_of(part.kind); ++k) text += ", " + number_in_words(row[part.at + k], digits);
    return "(" + text + ")";
}

namespace {

/// A function's formula, as Integrand has it.
template <class Number>
std::string formula_in_words(const Row& row, std::size_t at, Number number) {
    const auto p = [&](std::size_t i) { return number(row.at(at + 2 + i)); };
    switch (Integrand::Kind(int(row.at(at)))) {
        case Integrand::Kind::gaussian:
            return fmt::format("{} * exp(-pow((x - {}) / {}, 2) / 2)", p(0), p(1), p(2));
        case Integrand::Kind::lorentzian:
            return fmt::format("{} / (1 + pow((x - {}) / {}, 2))", p(0), p(1), p(2));
        case Integrand::Kind::cosine:
            return fmt::format("{} + {} * cos(2 * pi * {} * x + {})", p(0), p(1), p(2), p(3));
        case Integrand::Kind::exponential:
            return fmt::format("{} * exp(-{} * x)", p(0), p(1));
        case Integrand::Kind::power:
            return fmt::format("{} * pow(x, {})", p(0), p(1));
        case Integrand::Kind::step:
            return fmt::format("x < {} ? {} : {}", p(0), p(1), p(2));
        case Integrand::Kind::polynomial:
            break;
    }
    std::string text;
    for (std::size_t i = 0; i < std::size_t(row.at(at + 1)); ++i)
        text += fmt::format("{}{}{}", i ? " + " : "", p(i), i > 1 ? fmt::format(" * pow(x, {})", i) : i ? " * x" : "");
    return text;
}

/// The elements of a list, in words.
std::vector<std::string> elements_of(const List& list, const Row& row, int digits) {
    std::vector<std::string> all;
    std::size_t at = list.at + 1;
    for (std::size_t k = 0; k < list.count; ++k) {
        if (list.stride > 0) {
            all.push_back(value_in_words({"", list.stride == 3 ? Kind::color : Kind::number, at}, row, digits));
            at += list.stride;
            continue;
        }
        const std::size_t count = std::size_t(row.at(at + 2));
        std::string u;
        for (std::size_t i = 0; i < count; ++i) u += (i ? ", " : "") + number_in_words(row.at(at + 3 + i), digits);
        all.push_back(fmt::format("{{{}, {}, {{{}}}}}", number_in_words(row.at(at), digits),
                                  number_in_words(row.at(at + 1), digits), u));
        at += 3 + count;
    }
    return all;
}

}  // namespace

std::string arguments_in_words(const Signature& signature, const Row& row, const Printing& printing) {
    const auto& [told, always, digits] = printing;
    const Layout layout = signature.of_arguments(row), plain = signature.of_arguments(signature.blank());
    const Row defaults = signature.blank();
    std::string text;
    const auto tell = [&](const std::string& name, const std::string& value) {
        text += (text.empty() ? "" : ", ") + name + " = " + value;
    };
    for (std::size_t i = 0; i < layout.parts.size(); ++i) {
        if (i < told.size() && !told[i]) continue;
        const std::string value = value_in_words(layout.parts[i], row, digits);
        const bool is_field = layout.parts[i].name.find('.') != std::string::npos && !(i < always.size() && always[i]);
        if (!is_field || value != value_in_words(plain.parts[i], defaults, digits)) tell(layout.parts[i].name, value);
    }
    for (const Field& formula : layout.formulas)
        tell(formula.name + "(x)",
             formula_in_words(row, formula.at, [&](double x) { return number_in_words(x, printing.digits); }));
    for (const List& list : layout.lists) {
        constexpr std::size_t most = 6;
        std::string values;
        const auto elements = elements_of(list, row, printing.digits);
        for (std::size_t k = 0; k < std::min(elements.size(), most); ++k) values += (k ? ", " : "") + elements[k];
        tell(list.name,
             fmt::format("[{}{}]", values, list.count > most ? fmt::format(", ... {} in all", list.count) : ""));
    }
    return text;
}

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
        if (structures().contains(type)) before += fmt::format("{} {}{{}};\n", type, name);
        for (std::size_t i = 0; i < layout.parts.size(); ++i) {
            const std::string value = value_in_code(layout.parts[i], row);
            if (layout.parts[i].name.starts_with(name + ".") && value != value_in_code(plain.parts[i], defaults))
                before += fmt::format("{} = {};\n", layout.parts[i].name, value);
        }
    }
    return fmt::format("{}{}({});\n", before, signature.fragment, given);
}

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

std::string result_in_words(const Signature& signature, const Row& output, const std::vector<bool>& told) {
    const Layout layout = signature.of_result(output);
    std::string text;
    for (std::size_t i = 0; i < layout.parts.size(); ++i) {
        const Field& part = layout.parts[i];
        if (i < told.size() && !told[i]) continue;
        text +=
            (text.empty() ? "" : ", ") + (part.name.empty() ? "" : part.name + " = ") + value_in_words(part, output);
    }
    return text;
}

}  // namespace grade
