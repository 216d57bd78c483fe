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

/// Whether nearly all rows are as a suspect has them, among them some that are not right.
bool matches(const Observation& seen, const RowFunction& right, const Suspect& suspect, double tolerance) {
    std::size_t same = 0, telling = 0, wrong = 0;
    for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
        const Row expected = right(seen.inputs[k]), suspected = suspect.outputs(seen.inputs[k]);
        const bool as_suspected = deviation(seen.outputs[k], suspected) <= tolerance;
        const bool is_wrong = !(deviation(seen.outputs[k], expected) <= tolerance);
        same += as_suspected;
        wrong += is_wrong;
        telling += is_wrong && as_suspected;
    }
    return wrong > 0 && telling >= 0.95 * double(wrong) && same >= 0.95 * double(seen.inputs.size());
}

std::vector<double> deviations(const Observation& seen, const RowFunction& right) {
    std::vector<double> all;
    for (std::size_t k = 0; k < seen.inputs.size(); ++k)
        all.push_back(deviation(seen.outputs[k], right(seen.inputs[k])));
    return all;
}

/// Whether the rows that are wrong are those of a circumstance, and there are others.
bool goes_with(const Observation& seen, const std::vector<double>& off, const Circumstance& circumstance,
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
        if (outputs[k] != right[k]) worst = worse(std::abs(outputs[k] - right[k]) / scale, worst);
    }
    return worst;
}

Statistic formula(std::string id, std::string what, RowFunction right, double tolerance, std::vector<Suspect> suspects,
                  std::vector<Circumstance> circumstances) {
    Statistic s;
    s.id = std::move(id);
    s.what = std::move(what);
    s.truth = 0;
    s.delta = tolerance;
    s.exact = true;
    s.measure = [right](const Observation& seen) {
        double worst = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k)
            worst = worse(deviation(seen.outputs[k], right(seen.inputs[k])), worst);
        return worst;
    };
    s.hint = [](double value, double) { return fmt::format("the formula is off by up to {:.3g} of its value", value); };
    s.cause = [=](const Observation& seen) -> std::string {
        for (const Suspect& suspect : suspects)
            if (matches(seen, right, suspect, tolerance)) return suspect.words;

        const std::vector<double> off = deviations(seen, right);
        std::size_t worst = 0;
        for (std::size_t k = 0; k < off.size(); ++k)
            if (std::isnan(off[k]) || off[k] > off[worst]) worst = k;
        const auto wrong = std::count_if(off.begin(), off.end(), [=](double x) { return !(x <= tolerance); });
        std::string words;
        for (const Circumstance& circumstance : circumstances)
            if (words.empty() && goes_with(seen, off, circumstance, tolerance)) words = circumstance.words + ": ";
        return words + fmt::format("{} of {} calls are wrong; for arguments {} the result is {}, expected {}", wrong,
                                   off.size(), numbers(seen.inputs[worst]), numbers(seen.outputs[worst]),
                                   numbers(right(seen.inputs[worst])));
    };
    return s;
}

Statistic property(std::string id, std::string what, std::function<double(const Row&, const Row&)> violation,
                   double tolerance, std::string hint) {
    Statistic s;
    s.id = std::move(id);
    s.what = std::move(what);
    s.truth = 0;
    s.delta = tolerance;
    s.exact = true;
    s.measure = [violation](const Observation& seen) {
        double worst = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k)
            worst = worse(violation(seen.inputs[k], seen.outputs[k]), worst);
        return worst;
    };
    s.hint = [hint](double value, double) { return fmt::format("{} (off by {:.3g})", hint, value); };
    return s;
}

Rows repeat(Rows rows) {
    const std::size_t count = std::min(repeated, rows.size());
    for (std::size_t k = 0; k < count; ++k) rows.push_back(rows[k]);
    return rows;
}

Statistic purity() {
    Statistic s;
    s.id = "V0";
    s.what = "difference between two calls with the same arguments";
    s.truth = 0;
    s.exact = true;
    s.measure = [](const Observation& seen) {
        const std::size_t start = seen.outputs.size() - std::min(repeated, seen.outputs.size() / 2);
        double worst = 0;
        for (std::size_t k = start; k < seen.outputs.size(); ++k)
            worst = worse(deviation(seen.outputs[k], seen.outputs[k - start]), worst);
        return worst;
    };
    s.hint = [](double, double) {
        return std::string(
            "the result changes from call to call: a fragment has no random numbers of its own, they are arguments");
    };
    return s;
}

}  // namespace grade
