#include <algorithm>

#include "diagnosis/steps_made.h"

namespace grade {

namespace {

using rt::Real;

std::vector<Steps> of_uniform() {
    return {steps(
                "w * sum of f(a + (i + 0.5) * step) for i < n, w = step = (b - a) / n",
                "Real w; Real a; Real 0.5; Real step; int n; Real (b - a) / (n - 1); Real b - a; Real 1 / n",
                +[](const Integrand&, const Real& a, const Real& b, const int& n) {
                    return row((b - a) / n, a, 0.5, (b - a) / n, n, (b - a) / std::max(n - 1, 1), b - a, 1.0 / n);
                },
                +[](const double* s, const Integrand& f, const Real&, const Real&, const int&) {
                    Real sum = 0;
                    for (int i = 0; i < s[4]; ++i) sum += f(s[1] + (i + s[2]) * s[3]);
                    return row(s[0] * sum);
                }),
            steps(
                "f(a + i * step + 0.5 * step)",
                "Real 0.5 * step; bool a loop from i = 1; bool a loop that ends one i too early; bool i / n as a "
                "division of whole numbers; bool points (b - a) / (n - 1) apart, of which the first is a and the last "
                "b; bool the sum divided by n - 1 in place of n; bool the same points, of which those at both ends "
                "count half",
                +[](const Integrand&, const Real& a, const Real& b, const int& n) {
                    return row(0.5 * (b - a) / n, false, false, false, false, false, false);
                },
                +[](const double* s, const Integrand& f, const Real& a, const Real& b, const int& n) {
                    Real sum = 0;
                    if (s[4] != 0 || s[6] != 0) {
                        if (n == 1) return row((b - a) * f((a + b) / 2));
                        for (int i = 0; i < n; ++i)
                            sum += (s[6] != 0 && (i == 0 || i == n - 1) ? 0.5 : 1) * f(a + i * (b - a) / (n - 1));
                        return row((b - a) / (s[5] != 0 ? n - 1 : n) * sum);
                    }
                    for (int i = s[1] != 0; i < n - (s[2] != 0); ++i)
                        sum += f(a + (s[3] != 0 ? 0 : i) * (b - a) / n + s[0]);
                    return row((b - a) / (s[5] != 0 ? std::max(n - 1, 1) : n) * sum);
                })};
}

std::vector<Steps> of_monte_carlo() {
    using List = std::vector<Real>;
    return {steps(
        "the sum of f(x[i]) / density(x[i]) over x.size()",
        "int the number of terms; int x.size(); bool f(x[i]) * density(x[i]) as terms; bool f(x[i]) alone as terms; "
        "bool 1 / density(x[i]) as terms; bool the first term left out; bool the last term alone; bool the sum of 1 / "
        "density(x[i]) in place of x.size(); bool the sum of f(x[i]) over the sum of density(x[i]); bool the "
        "mean of f(x[i]) times the way from the least x to the greatest one; bool no division by x.size(); bool "
        "f(x[i]) / density(x[i])^2 as terms",
        +[](const Integrand&, const Integrand&, const List& x) {
            Row all = row(int(x.size()), int(x.size()));
            all.resize(12);
            return all;
        },
        +[](const double* s, const Integrand& f, const Integrand& density, const List& x) {
            const std::size_t last = std::min(x.size(), std::size_t(std::max(s[0], 0.0)));
            Real sum = 0, of_densities = 0, of_weights = 0, all_of = 0;
            for (std::size_t i = s[6] != 0 ? x.size() - 1 : s[5] != 0 ? 1 : 0; i < last; ++i) {
                const Real due = density(x[i]),
                           weight = s[2] != 0                ? due
                                    : s[3] != 0 || s[8] != 0 ? 1
                                                             : 1 / due,
                           again = s[11] != 0 ? due : 1;
                sum += weight / again * (s[4] != 0 ? 1 : f(x[i]));
                of_densities += due, of_weights += 1 / due;
            }
            if (s[9] != 0 && !x.empty()) {
                const auto [low, high] = std::ranges::minmax(x);
                for (const Real x_i : x) all_of += f(x_i);
                return row((high - low) * all_of / Real(x.size()));
            }
            if (s[10] != 0) return row(sum);
            const Real over = s[7] != 0 ? of_weights : s[8] != 0 ? of_densities : s[1];
            return row(x.empty() ? 0 : sum / over);
        })};
}

/// The sum over one stratum, with the mistakes of s that are made in it.
Real of_stratum(const double* s, const Integrand& f, const StratumOf& own, Real first_width) {
    const Real width = s[0] != 0 ? first_width : own.high - own.low;
    Real sum = 0;
    for (const Real u : own.u)
        sum += f((s[2] != 0    ? 0
                  : s[3] != 0  ? own.high
                  : s[22] != 0 ? (own.low + own.high) / 2
                               : own.low) +
                 (s[1] != 0    ? 1
                  : s[15] != 0 ? own.high
                               : width) *
                     (s[4] != 0    ? 0.5
                      : s[17] != 0 ? u / Real(own.u.size())
                                   : u));
    return sum;
}

/// With the mistakes of s in how the strata's sums are put together, or which numbers are used.
Real of_pooled_strata(const double* s, const Integrand& f, const std::vector<StratumOf>& strata) {
    Real width = 0, sum = 0, of_means = 0, of_ones = 0;
    std::size_t count = 0, filled = 0;
    for (const StratumOf& own : strata) {
        const Real size = own.high - own.low;
        Real values = 0;
        for (const Real u : own.u) values += f(own.low + u * size);
        width += size, sum += values, count += own.u.size();
        if (own.u.empty()) continue;
        ++filled, of_means += values / Real(own.u.size());
        of_ones += size * f(own.low + (s[20] != 0 ? own.u.front() : own.u.back()) * size);
    }
    if (s[20] != 0 || s[21] != 0 || count == 0) return of_ones;
    return width * (s[18] != 0 ? sum / Real(count) : of_means / Real(filled));
}

std::vector<Steps> of_strata() {
    using List = std::vector<StratumOf>;
    return {steps(
        "",
        "bool the width of the first stratum in all strata; bool f(low + u): u not multiplied by the width; bool f(u * "
        "width): low not added; bool f(high + u * width); bool the middle of each stratum in place of its u; bool a "
        "sum that is not set back to 0 for each stratum; bool no width before the sum of a stratum; bool no division "
        "by the number of u; bool the number of all u in place of that of the stratum; bool the number of strata in "
        "place of that of u; bool a division by the number of strata too many; bool the first stratum left out; bool "
        "the last stratum left out; bool the square of the number of u; bool the width of the last stratum before the "
        "sum of all; bool f(low + u * high): u multiplied by high; bool high in place of the width before the sum; "
        "bool u "
        "divided by the number of u; bool the mean of all values times the whole width: strata with many numbers "
        "count too much; bool the mean of the strata's means times the whole width; bool the first u of each stratum "
        "alone; bool the last u of each stratum alone; bool f((low + high) / 2 + u * width)",
        +[](const Integrand&, const List&) { return Row(23); },
        +[](const double* s, const Integrand& f, const List& strata) {
            if (s[18] != 0 || s[19] != 0 || s[20] != 0 || s[21] != 0) return row(of_pooled_strata(s, f, strata));
            std::size_t all = 0;
            for (const StratumOf& own : strata) all += own.u.size();
            const auto width = [](const StratumOf& own) { return own.high - own.low; };
            Real total = 0, sum = 0;
            for (std::size_t k = s[11] != 0; k + (s[12] != 0) < strata.size(); ++k) {
                const StratumOf& own = strata[k];
                if (own.u.empty()) continue;
                const Real before = width(s[0] != 0 ? strata.front() : s[14] != 0 ? strata.back() : own);
                const Real count = Real(s[8] != 0 ? all : s[9] != 0 ? strata.size() : own.u.size());
                sum = (s[5] != 0 ? sum : 0) + of_stratum(s, f, own, width(strata.front()));
                total += (s[6] != 0    ? 1
                          : s[16] != 0 ? own.high
                                       : before) *
                         sum /
                         (s[7] != 0    ? 1
                          : s[13] != 0 ? count * count
                                       : count);
            }
            return row(s[10] != 0 ? total / Real(strata.size()) : total);
        })};
}

}  // namespace

std::vector<Steps> steps_of_integrals(const std::string& fragment) {
    if (fragment == "integrate_uniform") return of_uniform();
    if (fragment == "integrate_monte_carlo") return of_monte_carlo();
    if (fragment == "integrate_stratified") return of_strata();
    return {};
}

}  // namespace grade
