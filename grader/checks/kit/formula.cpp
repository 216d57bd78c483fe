#include "checks/kit/formula.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grade {

namespace {

constexpr std::size_t repeated = 16;

/// The larger one; a nan wins.
double worse(double a, double b) { return std::isnan(a) || a > b ? a : b; }

std::string numbers(const Row& row) {
    constexpr std::size_t most = 20;
    const Row shown(row.begin(), row.begin() + std::ptrdiff_t(std::min(row.size(), most)));
    return fmt::format("({:.6g}{})", fmt::join(shown, ", "), row.size() > most ? ", ..." : "");
}

/// How many rows are as a suspect has them, where all are but for a few on an edge, and among them some that are not
/// right; else 0.
std::size_t matching(const Observation& seen, const Rows& right, const RowSuspect& suspect, double tolerance) {
    std::size_t same = 0, telling = 0, wrong = 0;
    for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
        const bool as_suspected = deviation(seen.outputs[k], suspect.outputs(seen.inputs[k], right[k])) <= tolerance;
        const bool is_wrong = !(deviation(seen.outputs[k], right[k]) <= tolerance);
        same += as_suspected;
        wrong += is_wrong;
        telling += is_wrong && as_suspected;
    }
    const bool is_all = wrong > 0 && telling >= 0.95 * double(wrong) && same >= 0.99 * double(seen.inputs.size());
    return is_all ? same : 0;
}

/// Whether the rows that are wrong are those of a circumstance, and there are others.
bool goes_with(const Observation& seen, const std::vector<double>& off, const RowCircumstance& circumstance,
               double tolerance) {
    double wrong = 0, holding = 0, both = 0;
    for (std::size_t k = 0; k < off.size(); ++k) {
        const bool is_wrong = !(off[k] <= tolerance), holds = circumstance.holds(seen.inputs[k]);
        wrong += is_wrong;
        holding += holds;
        both += is_wrong && holds;
    }
    return both >= 0.98 * wrong && both >= 0.3 * holding && holding <= 0.95 * double(off.size());
}

}  // namespace

double deviation(const Row& outputs, const Row& right) {
    if (outputs.size() < right.size()) return rt::inf;
    double scale = 1e-3, worst = 0;
    for (const double x : right)
        if (std::isfinite(x)) scale = std::max(scale, std::abs(x));
    for (std::size_t k = 0; k < right.size(); ++k) {
        if (std::isnan(right[k]) && std::isnan(outputs[k])) continue;
        const double larger = std::isfinite(outputs[k]) ? std::max(scale, std::abs(outputs[k])) : scale;
        if (outputs[k] != right[k]) worst = worse(std::abs(outputs[k] - right[k]) / larger, worst);
    }
    return worst;
}

namespace {

/// The cause as formula() has it.
Shown cause_of(const RowFormula& f, const Observation& seen) {
    Rows right;
    for (const Row& inputs : seen.inputs) right.push_back(f.right(inputs));
    std::size_t most = 0;
    std::string best;
    for (const RowSuspect& suspect : f.suspects)
        if (const std::size_t same = matching(seen, right, suspect, f.tolerance); same > most)
            most = same, best = suspect.words;
    if (most > 0) return best;

    std::vector<double> off;
    for (std::size_t k = 0; k < right.size(); ++k) off.push_back(deviation(seen.outputs[k], right[k]));
    std::size_t worst = 0;
    for (std::size_t k = 0; k < off.size(); ++k)
        if (std::isnan(off[k]) || off[k] > off[worst]) worst = k;
    const auto wrong = std::ranges::count_if(off, [&](double x) { return !(x <= f.tolerance); });
    std::string words;
    for (const RowCircumstance& circumstance : f.circumstances)
        if (words.empty() && goes_with(seen, off, circumstance, f.tolerance)) words = circumstance.words;
    return {words,
            fmt::format("{} of {} calls are wrong; for arguments {} the result is {}, expected {}", wrong, off.size(),
                        numbers(seen.inputs[worst]), numbers(seen.outputs[worst]), numbers(right[worst]))};
}

/// The largest number of any row.
std::function<double(const Observation&)> largest(RowNumber number) {
    return [number](const Observation& seen) {
        double worst = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k)
            worst = worse(number(seen.inputs[k], seen.outputs[k]), worst);
        return worst;
    };
}

bool all_within(const Observation& seen, const RowNumber& violation, double tolerance) {
    for (std::size_t k = 0; k < seen.inputs.size(); ++k)
        if (!(violation(seen.inputs[k], seen.outputs[k]) < tolerance)) return false;
    return true;
}

std::function<double(const Observation&)> wrong_calls(const RowFunction& right) {
    return [right](const Observation& seen) {
        double count = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k)
            count += deviation(seen.outputs[k], right(seen.inputs[k])) != 0;
        return count;
    };
}

}  // namespace

Statistic formula(const RowFormula& f) {
    const auto off = [right = f.right](const Row& in, const Row& out) { return deviation(out, right(in)); };
    return {.id = f.id,
            .what = f.what,
            .measure = f.tolerance > 0 ? largest(off) : wrong_calls(f.right),
            .truth = 0,
            .delta = f.tolerance,
            .exact = true,
            .hint = [](double value,
                       double) { return fmt::format("the formula is off by up to {:.3g} of its value", value); },
            .cause = [f](const Observation& seen) { return cause_of(f, seen); }};
}

Statistic property(const Property& p) {
    Statistic s{.id = p.id,
                .what = p.what,
                .measure = largest(p.violation),
                .truth = 0,
                .delta = p.tolerance,
                .exact = true,
                .hint =
                    [says = p.says](double value, double) {
                        // 1: yes, without an amount
                        return std::isfinite(value) && value != 1 ? fmt::format("{} (off by {:.3g})", says, value)
                                                                  : says;
                    },
                .hint_is_fact = true};
    if (!p.mistakes.empty())
        s.cause = [p](const Observation& seen) -> Shown {
            for (const auto& [words, violation] : p.mistakes)
                if (all_within(seen, violation, p.tolerance)) return words;
            return "";
        };
    return s;
}

std::function<Rows(Generator&)> with_repeats(std::function<Rows(Generator&)> inputs) {
    return [inputs](Generator& random) {
        Rows rows = inputs(random);
        const std::size_t count = std::min(repeated, rows.size());
        for (std::size_t k = 0; k < count; ++k) rows.push_back(rows[k]);
        return rows;
    };
}

Statistic purity() {
    return {.id = "V0",
            .what = "difference between two calls with the same arguments",
            .measure =
                [](const Observation& seen) {
                    const std::size_t start = seen.outputs.size() - std::min(repeated, seen.outputs.size() / 2);
                    double worst = 0;
                    for (std::size_t k = start; k < seen.outputs.size(); ++k)
                        worst = worse(deviation(seen.outputs[k], seen.outputs[k - start]), worst);
                    return worst;
                },
            .truth = 0,
            .exact = true,
            .cause = [](const Observation&) -> Shown {
                return "the result changes from call to call: a fragment has no random numbers of its own, they are "
                       "arguments";
            }};
}

}  // namespace grade
