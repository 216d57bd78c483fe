#include "diagnosis/calls/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "protocol/rows.h"

namespace grade {

double rounded(double x, int digits) {
    // std::stod throws where the rounded number is too large, or denormal
    return std::isfinite(x) ? std::strtod(fmt::format("{:.{}g}", x, digits).c_str(), nullptr) : x;
}

std::string number_in_words(double x, int digits) {
    if (std::isnan(x)) return "nan";
    // of what is nearly a whole number, say, more digits: 1 - 2^-30 is not 1
    const double shown = digits > 0 ? rounded(x, 2) : x;
    if (std::isfinite(x) && digits < 10 && std::abs(x - shown) > 1e-12 * std::abs(x) &&
        fmt::format("{:.{}g}", x, digits) == fmt::format("{:.{}g}", shown, digits))
        digits = 10;
    return digits > 0 ? fmt::format("{:.{}g}", x == 0 ? 0.0 : x, digits) : fmt::format("{}", x == 0 ? 0.0 : x);
}

std::string value_in_words(const Field& part, const Row& row, int digits) {
    if (part.kind == Kind::flag) return row[part.at] != 0 ? "true" : "false";
    if (part.kind == Kind::choice) {
        const auto& names = choices_of(part);
        return row[part.at] < double(names.size()) ? names[std::size_t(row[part.at])] : number_in_words(row[part.at]);
    }
    std::string text = number_in_words(row[part.at], digits);
    if (size_of(part.kind) == 1) return text;
    for (std::size_t k = 1; k < size_of(part.kind); ++k) text += ", " + number_in_words(row[part.at + k], digits);
    return "(" + text + ")";
}

std::string formula_in_words(const Row& row, std::size_t at, const std::function<std::string(double)>& number) {
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

namespace {

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
