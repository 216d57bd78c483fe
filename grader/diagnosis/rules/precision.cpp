#include "diagnosis/rules/precision.h"

#include <fmt/format.h>

namespace grade {

namespace {

bool is_float(double x) { return double(float(x)) == x; }

/// Whether a number has few digits, as 0, 1/2 or 12 have: any precision holds it.
bool is_short(double x) {
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(x, &exponent), 12);
    return mantissa == std::round(mantissa);
}

/// Whether nearly all numbers that differ do so from about the seventh digit on.
bool have_seven_digits(const Calls& calls) {
    constexpr double least = 1e-9, most = 3e-6, nearly_all = 0.8;
    constexpr int enough = 32;
    int seven = 0, all = 0;
    for (std::size_t k = 0; k < calls.size(); ++k)
        for (std::size_t i = 0; i < std::min(calls.mine[k].size(), calls.right[k].size()); ++i) {
            const double mine = calls.mine[k][i], right = calls.right[k][i];
            if (!std::isfinite(mine) || !std::isfinite(right) || mine == right) continue;
            const double off = std::abs(mine - right) / std::max(std::abs(mine), std::abs(right));
            ++all, seven += off >= least && off <= most;
        }
    return seven >= enough && seven >= nearly_all * all;
}

}  // namespace

std::string in_single_precision(const Calls& calls) {
    const std::string seven_digits = have_seven_digits(calls)
                                         ? "the answers have about seven digits: is `float` used, or a constant or a "
                                           "tolerance with as few? `Real` is double"
                                         : "";
    int floats = 0, longer = 0;
    for (std::size_t k = 0; k < calls.size(); ++k)
        for (std::size_t i = 0; i < std::min(calls.mine[k].size(), calls.right[k].size()); ++i) {
            const double mine = calls.mine[k][i], right = calls.right[k][i];
            if (!std::isfinite(mine) || mine == right || is_short(mine)) continue;
            if (!is_float(mine)) return seven_digits;
            ++floats, longer += !is_float(right);
        }
    constexpr int enough = 8;
    if (floats < enough || 2 * longer < floats) return seven_digits;
    return "every number of the answers has the 7 digits of single precision: is `float` used? `Real` is double";
}

std::string by_double(const Calls& calls, const InDouble& source) {
    const Rows answers = source.ask(calls.rows);
    if (answers.size() != calls.size()) return {};
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (!is_equal(calls.result, answers[k], calls.right[k])) return {};
    return fmt::format("with {} in line {}, every answer is right: {}", source.words, source.line, source.since);
}

InLine by_reals(const Calls& calls, const std::vector<MadeInDouble>& sources) {
    InLine all;
    for (const MadeInDouble& made : sources) {
        const auto source = made();
        InLine one = source ? InLine{by_double(calls, *source), source->line} : InLine{};
        if (&made != &sources.front() && !one.words.empty()) return one;
        if (&made == &sources.front() && (all = std::move(one)).words.empty()) return {};
    }
    return all;
}

bool are_near(const Calls& all) {
    constexpr double nearly = 1e-3;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (!is_alike(all.result, all.mine[k], all.right[k], nearly)) return false;
    return true;
}

}  // namespace grade
