#include "diagnosis/changes/products.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnosis/calls/quantities.h"
#include "diagnosis/changes/constants.h"
#include "rt/math.h"

namespace grade {

namespace {

/// Columns of logarithms, of quantities that a factor may hold.
struct Column {
    std::string words;
    std::vector<double> log;
};

bool is_of_vectors(const Quantity& q) { return q.kind != Quantity::Kind::number; }

std::vector<Column> columns_of(const PartOfCalls& of) {
    std::vector<Column> list;
    const auto add = [&](const std::string& words, auto value) {
        std::vector<double> log;
        double least = rt::inf, most = -rt::inf;
        for (const std::size_t k : of.scope) {
            log.push_back(value(k));
            least = std::min(least, log.back()), most = std::max(most, log.back());
        }
        if (std::isfinite(least) && std::isfinite(most) && most - least > 1e-3) list.push_back({words, std::move(log)});
    };
    const auto quantities = quantities_of(of.calls.layouts.front(), told_of(of.calls, of.scope), &of.calls.result);
    const auto at = [&](const Quantity& q, std::size_t k) {
        return q.value(of.calls.rows[k], of.calls.layouts[k], of.calls.mine[k]);
    };
    for (const Quantity& q : quantities)
        if (q.answer_at != of.part.at) {
            const bool is_signed = std::ranges::any_of(of.scope, [&](std::size_t k) { return at(q, k) < 0; });
            add(is_signed ? "|" + q.words + "|" : q.words, [&](std::size_t k) { return std::log(std::abs(at(q, k))); });
        }
    const std::size_t numbers = std::size_t(std::ranges::find_if(quantities, is_of_vectors) - quantities.begin());
    constexpr std::size_t few = 4;
    for (std::size_t a = 0; a < numbers && numbers <= few; ++a)
        for (std::size_t b = a + 1; b < numbers; ++b)
            add(fmt::format("({} - {})", quantities[b].words, quantities[a].words),
                [&](std::size_t k) { return std::log(std::abs(at(quantities[b], k) - at(quantities[a], k))); });
    for (const Quantity& q : quantities) {
        if (is_of_vectors(q)) continue;
        for (const int more : {1, 2})
            add(fmt::format("({} + {})", q.words, more),
                [&](std::size_t k) { return std::log(std::abs(at(q, k) + more)); });
        const bool is_small = std::ranges::all_of(of.scope, [&](std::size_t k) { return at(q, k) <= 1; });
        add(is_small ? fmt::format("(1 - {})", q.words) : fmt::format("({} - 1)", q.words),
            [&](std::size_t k) { return std::log(std::abs(at(q, k) - 1)); });
        add(fmt::format("sqrt(1 - {0} * {0})", q.words),
            [&](std::size_t k) { return std::log(1 - at(q, k) * at(q, k)) / 2; });
        for (const Quantity& base : quantities)
            if (base.kind == Quantity::Kind::product || base.kind == Quantity::Kind::coordinate)
                add(fmt::format("pow({}, {})", base.words, q.words),
                    [&](std::size_t k) { return at(q, k) * std::log(at(base, k)); });
    }
    return list;
}

/// Mine over right in each call of the scope, the same in all components: its logarithm, and its one sign.
struct Ratio {
    std::vector<double> log;
    bool is_negative = false;
};

std::optional<Ratio> ratio_of(const PartOfCalls& of) {
    Ratio all;
    for (const std::size_t k : of.scope) {
        std::size_t most = 0;
        for (std::size_t c = 1; c < of.size(); ++c)
            if (std::abs(of.right(k, c)) > std::abs(of.right(k, most))) most = c;
        const double ratio = of.mine(k, most) / of.right(k, most);
        if (!(std::abs(ratio) > 0) || !std::isfinite(ratio)) return std::nullopt;
        if (!all.log.empty() && all.is_negative != (ratio < 0)) return std::nullopt;
        all.is_negative = ratio < 0;
        for (std::size_t c = 0; c < of.size(); ++c)
            if (!is_close(of.mine(k, c), ratio * of.right(k, c), std::abs(of.mine(k, most)))) return std::nullopt;
        all.log.push_back(std::log(std::abs(ratio)));
    }
    return all;
}

std::optional<double> nice_power(double p) {
    for (const double nice : {1.0, 2.0, 0.5, 3.0, 4.0, 1.5})
        if (std::abs(std::abs(p) - nice) < 1e-3) return std::copysign(nice, p);
    return std::nullopt;
}

struct Power {
    std::string words;
    double p;
};

/// "2 * x / y^2"
std::string product_in_words(double c, const std::vector<Power>& powers) {
    std::string above = std::abs(c - 1) < 1e-4 ? "" : constant(c), below;
    for (const auto& [words, p] : powers) {
        const double size = std::abs(p);
        const std::string one = size == 1     ? words
                                : size == 0.5 ? "sqrt(" + words + ")"
                                              : fmt::format("{}^{:g}", words, size);
        std::string& side = p > 0 ? above : below;
        side += (side.empty() ? "" : " * ") + one;
    }
    if (below.empty()) return above;
    const bool is_many = below.find(" * ") != below.npos;
    return fmt::format(fmt::runtime(is_many ? "{} / ({})" : "{} / {}"), above.empty() ? "1" : above, below);
}

struct Fit {
    double constant;
    std::array<double, 2> powers;
};

/// log = constant + powers . columns, exactly.
std::optional<Fit> fitted(const std::vector<double>& log, const std::vector<const Column*>& columns) {
    const std::size_t n = log.size(), m = columns.size();
    if (n < 5 + m) return std::nullopt;
    const auto mean = [n](const std::vector<double>& v) {
        double sum = 0;
        for (const double x : v) sum += x;
        return sum / double(n);
    };
    const double y = mean(log);
    if (!std::isfinite(y)) return std::nullopt;
    std::array<double, 2> x{};
    for (std::size_t a = 0; a < m; ++a) x[a] = mean(columns[a]->log);
    double xx = 0, xz = 0, zz = 0, xy = 0, zy = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const double dx = columns[0]->log[k] - x[0], dz = m > 1 ? columns[1]->log[k] - x[1] : 0, dy = log[k] - y;
        xx += dx * dx, xz += dx * dz, zz += dz * dz, xy += dx * dy, zy += dz * dy;
    }
    Fit fit{0, {}};
    if (m == 1)
        fit.powers[0] = xy / xx;
    else {
        const double determinant = xx * zz - xz * xz;
        if (!(determinant > 1e-6 * xx * zz)) return std::nullopt;
        fit.powers = {(xy * zz - zy * xz) / determinant, (zy * xx - xy * xz) / determinant};
    }
    fit.constant = y - fit.powers[0] * x[0] - fit.powers[1] * x[1];
    for (std::size_t k = 0; k < n; ++k) {
        double value = fit.constant;
        for (std::size_t a = 0; a < m; ++a) value += fit.powers[a] * columns[a]->log[k];
        if (!(std::abs(value - log[k]) < equal_within)) return std::nullopt;
    }
    return fit;
}

/// The number whose logarithm stands everywhere.
std::optional<double> fitted_constant(const std::vector<double>& log) {
    for (const double x : log)
        if (!(std::abs(x - log.front()) < equal_within)) return std::nullopt;
    return log.size() < 5 ? std::nullopt : std::optional(std::exp(log.front()));
}

struct Product {
    std::string words;
    std::size_t factors;
};

/// The first product of plain powers of one column, or of two, whose logarithm stands everywhere.
///
/// any_constant  of one column, the constant may be one without a name
std::optional<Product> fitted_product(const std::vector<double>& log, const std::vector<Column>& all, bool any_constant,
                                      std::size_t most_factors) {
    const auto product = [&](const std::vector<const Column*>& columns, bool is_any) -> std::optional<Product> {
        const auto fit = fitted(log, columns);
        if (!fit || (!is_any && !is_named(std::exp(fit->constant)))) return std::nullopt;
        std::vector<Power> powers;
        for (std::size_t a = 0; a < columns.size(); ++a)
            if (const auto p = nice_power(fit->powers[a])) powers.push_back({columns[a]->words, *p});
        if (powers.size() < columns.size()) return std::nullopt;
        return Product{product_in_words(std::exp(fit->constant), powers), columns.size()};
    };
    for (const Column& q : all)
        if (auto found = product({&q}, any_constant)) return found;
    for (std::size_t a = 0; a < all.size() && most_factors > 1; ++a)
        for (std::size_t b = a + 1; b < all.size(); ++b)
            if (auto found = product({&all[a], &all[b]}, false)) return found;
    return std::nullopt;
}

}  // namespace

std::optional<AnswerForm> quantity_of(const PartOfCalls& of) {
    if (of.size() != 1 || of.part.kind != Kind::number) return std::nullopt;
    std::vector<double> log, log_of_right;
    for (const std::size_t k : of.scope) {
        log.push_back(std::log(std::abs(of.mine(k, 0))));
        log_of_right.push_back(std::log(std::abs(of.right(k, 0))));
    }
    const std::vector<Column> columns = columns_of(of);
    const auto found = fitted_product(log, columns, false, 2);
    if (!found) return std::nullopt;
    const auto right = fitted_product(log_of_right, columns, false, 2);
    const std::string due = right ? fmt::format("; it must be `{}`", right->words) : "";
    return AnswerForm{fmt::format("is `{}`{}", found->words, due), found->factors == 1 ? 2.4 : 3.4};
}

std::optional<AnswerForm> difference_of(const PartOfCalls& of) {
    if (of.size() != 1 || of.part.kind != Kind::number) return std::nullopt;
    std::vector<double> log;
    bool is_more = true, is_less = true;
    for (const std::size_t k : of.scope) {
        const double off = of.mine(k, 0) - of.right(k, 0);
        if (!(std::abs(off) > 1e-3 * std::abs(of.right(k, 0))) || !std::isfinite(off)) return std::nullopt;
        is_more = is_more && off > 0, is_less = is_less && off < 0;
        log.push_back(std::log(std::abs(off)));
    }
    if (!is_more && !is_less) return std::nullopt;
    const std::string words = is_more ? "is what it must be, and `{}` more" : "is what it must be, less `{}`";
    if (const auto fit = fitted_constant(log)) return AnswerForm{fmt::format(fmt::runtime(words), constant(*fit)), 2.4};
    const auto found = fitted_product(log, columns_of(of), false, 1);
    return found ? std::optional(AnswerForm{fmt::format(fmt::runtime(words), found->words), 2.5}) : std::nullopt;
}

std::optional<AnswerForm> product_of(const PartOfCalls& of) {
    const auto ratio = ratio_of(of);
    if (!ratio) return std::nullopt;
    const auto found = fitted_product(ratio->log, columns_of(of), true, 2);
    if (!found) return std::nullopt;
    return AnswerForm{fmt::format("is `{}{}` times what it must be", ratio->is_negative ? "-" : "", found->words),
                      found->factors == 1 ? 2.5 : 3.5};
}

}  // namespace grade
