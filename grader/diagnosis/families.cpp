#include "diagnosis/families.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/constants.h"
#include "diagnosis/scalars.h"

namespace grade {

namespace {

constexpr double cost_of_constant = 2.3;
constexpr std::size_t most_wrong = 3;  // calls that the constant is found with

/// What is done to a number or to a vector.
struct Family {
    const char* words;  // {0} is the argument, {1} the constant
    double (*value)(double x, double c);
};

constexpr Family scaled{"{1} * {0}", [](double x, double c) { return c * x; }};
constexpr Family moved{"{0} + {1}", [](double x, double c) { return x + c; }};
constexpr Family lowered{"{0} - {1}", [](double x, double c) { return x - c; }};
constexpr Family raised{"pow({0}, {1})", [](double x, double c) { return std::pow(x, c); }};
constexpr Family fixed{"{1}", [](double, double c) { return c; }};
constexpr Family from_above{"min({0}, {1})", [](double x, double c) { return std::min(x, c); }};
constexpr Family from_below{"max({0}, {1})", [](double x, double c) { return std::max(x, c); }};

/// Numbers of an argument that a family is applied to.
struct Spot {
    std::string name;
    std::size_t part, component, count;
};

std::vector<double> spaced(double low, double high, int count, bool by_factors) {
    std::vector<double> list;
    for (int i = 0; i < count; ++i) {
        const double x = i / double(count - 1);
        list.push_back(by_factors ? low * std::pow(high / low, x) : low + (high - low) * x);
    }
    return list;
}

class ConstantSearch {
public:
    ConstantSearch(const Calls& calls, const Ask& right, const std::vector<std::size_t>& wrong)
        : calls_(calls), right_(right) {
        for (const std::size_t k : wrong) {
            const auto& answer = calls.mine[k];
            if (some_.size() < most_wrong && std::ranges::all_of(answer, [](double x) { return std::isfinite(x); }))
                some_.push_back(k);
        }
    }

    void look(const Spot& spot) {
        if (some_.empty()) return;
        double low = rt::inf, high = -rt::inf;
        for (std::size_t k = 0; k < calls_.size(); ++k)
            for (std::size_t c = 0; c < spot.count; ++c) {
                const double x = number(k, spot, c);
                if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
            }
        if (!(high > low)) return;
        std::vector<double> factors = spaced(0.02, 50, 40, true);
        for (const double x : spaced(0.02, 50, 20, true)) factors.push_back(-x);
        try_one(scaled, spot, std::move(factors), some_);
        if (spot.count > 1) return;
        const double range = high - low;
        const std::vector<double> steps = spaced(0.01 * range, 2 * range, 40, true);
        try_one(moved, spot, steps, some_);
        try_one(lowered, spot, steps, some_);
        if (low >= 0) try_one(raised, spot, spaced(0.1, 8, 40, true), some_);
        std::vector<double> values = spaced(low, high, 60, false);
        if (high > 0)
            for (const double x : spaced(std::max(low, 1e-4 * high), high, 60, true)) values.push_back(x);
        const auto c = found(fixed, spot, std::move(values), {some_.front()});
        if (!c) return;
        for (const Family& family : {fixed, from_above, from_below}) add(family, spot, *c);
    }

    std::vector<Change> take() { return std::move(all_); }

private:
    double number(std::size_t k, const Spot& spot, std::size_t c) const {
        return calls_.rows[k][calls_.layouts[k].parts[spot.part].at + spot.component + c];
    }

    static void apply(const Family& family, const Spot& spot, double c, Row& row, const Layout& layout) {
        for (std::size_t i = 0; i < spot.count; ++i) {
            double& x = row[layout.parts[spot.part].at + spot.component + i];
            x = family.value(x, c);
        }
    }

    /// How far the solution's answers with these constants are from mine, in the size of the answers.
    std::vector<double> errors(const Family& family, const Spot& spot, const std::vector<double>& constants,
                               const std::vector<std::size_t>& calls) const {
        Rows rows;
        for (const double c : constants)
            for (const std::size_t k : calls) {
                rows.push_back(calls_.rows[k]);
                apply(family, spot, c, rows.back(), calls_.layouts[k]);
            }
        const Rows answers = right_(rows);
        std::vector<double> all(constants.size(), rt::inf);
        for (std::size_t i = 0; i < constants.size() && answers.size() == rows.size(); ++i) {
            all[i] = 0;
            for (std::size_t j = 0; j < calls.size(); ++j)
                for (const Field& part : calls_.result.parts) {
                    const Row& mine = calls_.mine[calls[j]];
                    const Row& other = answers[i * calls.size() + j];
                    const double scale = scale_of(part, mine, mine);
                    for (std::size_t c = 0; c < size_of(part.kind); ++c) {
                        const double off = std::abs(mine[part.at + c] - other[part.at + c]) / scale;
                        all[i] = std::max(all[i], std::isnan(off) ? rt::inf : off);
                    }
                }
        }
        return all;
    }

    /// The constant with which the answers to these calls are mine: the best one, then better ones about it.
    std::optional<double> found(const Family& family, const Spot& spot, std::vector<double> constants,
                                const std::vector<std::size_t>& calls) const {
        constexpr int most_times = 8;
        for (int time = 0; time < most_times; ++time) {
            std::ranges::sort(constants);
            const std::vector<double> off = errors(family, spot, constants, calls);
            const std::size_t best = std::size_t(std::ranges::min_element(off) - off.begin());
            if (off[best] < 1e-9) return constants[best];
            if (!std::isfinite(off[best]) || off[best] > 3) return std::nullopt;
            if (time == most_times - 1) return off[best] < equal_within ? std::optional(constants[best]) : std::nullopt;
            const double low = constants[best > 0 ? best - 1 : 0],
                         high = constants[std::min(best + 1, constants.size() - 1)];
            constants = spaced(low, high, 17, false);
        }
        return std::nullopt;
    }

    void try_one(const Family& family, const Spot& spot, std::vector<double> constants,
                 const std::vector<std::size_t>& calls) {
        if (const auto c = found(family, spot, std::move(constants), calls)) add(family, spot, *c);
    }

    /// Where a person would have written that constant.
    void add(const Family& family, const Spot& spot, double c) {
        const double few_digits = rounded(c, 4);
        const bool is_short = std::abs(few_digits - c) <= equal_within * std::abs(c);
        const bool is_usual = std::abs(c) > 1e-4 && std::abs(c) < 1e4;
        if ((!is_short && !is_named(c)) || !is_usual) return;
        const double used = is_named(c) ? c : few_digits;
        const std::string words =
            fmt::format(fmt::runtime(family.words), spot.name, is_named(c) ? constant(c) : number_in_words(few_digits));
        all_.push_back({fmt::format("`{}` in place of `{}`", words, spot.name),
                        cost_of_constant,
                        [=](Row& row, const Layout& layout) {
                            apply(family, spot, used, row, layout);
                            return true;
                        },
                        {}});
    }

    const Calls& calls_;
    const Ask& right_;
    std::vector<std::size_t> some_;
    std::vector<Change> all_;
};

}  // namespace

std::vector<Change> changes_with_constants(const Calls& calls, const Ask& right,
                                           const std::vector<std::size_t>& wrong) {
    ConstantSearch search(calls, right, wrong);
    const Layout& layout = calls.layouts.front();
    for (const Scalar& s : scalars_of(layout, calls.told))
        if (!s.whole) search.look({s.name, s.part, s.component, 1});
    for (std::size_t i = 0; i < layout.parts.size(); ++i)
        if ((layout.parts[i].kind == Kind::vector || layout.parts[i].kind == Kind::color) &&
            (i >= calls.told.size() || calls.told[i]))
            search.look({layout.parts[i].name, i, 0, 3});
    return search.take();
}

}  // namespace grade
