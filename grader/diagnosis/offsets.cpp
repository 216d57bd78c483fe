#include "diagnosis/offsets.h"

#include <fmt/format.h>

#include "diagnosis/scalars.h"

namespace grade {

namespace {

constexpr double rounding = 1e-8;  // of the size of an answer, below which nothing is told

/// How far a part is off in each call; empty: nowhere.
std::vector<Row> offsets_of(const Calls& calls, const Field& part) {
    std::vector<Row> all;
    bool is_off = false;
    for (std::size_t k = 0; k < calls.size(); ++k) {
        all.emplace_back();
        for (std::size_t c = 0; c < size_of(part.kind); ++c) {
            const double mine = calls.mine[k][part.at + c], right = calls.right[k][part.at + c];
            all[k].push_back(mine == right ? 0 : mine - right);
        }
        is_off = is_off || !is_equal(part, calls.mine[k], calls.right[k], rounding);
    }
    return is_off ? all : std::vector<Row>{};
}

/// The constant c with which every offset is c * value(call, component).
template <class Value>
std::optional<double> factor(const std::vector<Row>& offsets, Value value) {
    constexpr double enough = 1e-3;
    double top = 0, bottom = 0;
    for (std::size_t k = 0; k < offsets.size(); ++k)
        for (std::size_t c = 0; c < offsets[k].size(); ++c)
            if (const double x = value(k, c); std::isfinite(x)) top += x * offsets[k][c], bottom += x * x;
    if (!(bottom > 0) || top == 0) return std::nullopt;
    for (std::size_t k = 0; k < offsets.size(); ++k)
        for (std::size_t c = 0; c < offsets[k].size(); ++c)
            if (const double due = top / bottom * value(k, c);
                std::isfinite(due) &&
                !(std::abs(due - offsets[k][c]) <= enough * std::sqrt(top * top / bottom / double(offsets.size()))))
                return std::nullopt;
    return top / bottom;
}

}  // namespace

std::string small_offsets(const Calls& calls) {
    std::string words;
    const auto tell = [&](const Field& part, const std::string& off) {
        words += fmt::format("{}{} is off by `{}`", words.empty() ? "" : ", and ",
                             part.name.empty() ? "the answer" : "`" + part.name + "`", off);
    };
    const auto& parts = calls.layouts.empty() ? std::vector<Field>{} : calls.layouts.front().parts;
    for (const Field& part : calls.result.parts) {
        const auto offsets = offsets_of(calls, part);
        if (offsets.empty()) continue;
        if (const auto c = factor(offsets, [](std::size_t, std::size_t) { return 1.0; });
            c && part.kind == Kind::number) {
            tell(part, number_in_words(*c, 3));
            continue;
        }
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (size_of(parts[i].kind) != size_of(part.kind)) continue;
            const auto c = factor(offsets, [&](std::size_t k, std::size_t component) {
                return calls.rows[k][calls.layouts[k].parts[i].at + component];
            });
            if (!c) continue;
            tell(part, number_in_words(*c, 3) + " * " + parts[i].name);
            break;
        }
    }
    return words;
}

}  // namespace grade
