#include "convergence/fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "statistics/distributions.h"
#include "statistics/moments.h"

namespace grade::convergence {

namespace {

/// A level as the fit sees it.
struct LevelPoint {
    double log_n, mse;
};

/// The law's numbers: log v, q, b^2.
using Unknowns = std::array<double, 3>;
using Matrix = std::array<Unknowns, 3>;

double power_part(const Unknowns& u, double log_n) { return std::exp(u[0] - 2 * u[1] * log_n); }

/// The inverse of the upper left part of a symmetric positive matrix, by Gauss and Jordan's elimination; what is beyond
/// that part stays 0.
Matrix inverse(Matrix a, std::size_t count) {
    Matrix b{};
    for (std::size_t i = 0; i < count; ++i) b[i][i] = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double pivot = a[i][i];
        for (std::size_t k = 0; k < count; ++k) a[i][k] /= pivot, b[i][k] /= pivot;
        for (std::size_t j = 0; j < count; ++j) {
            if (j == i) continue;
            const double factor = a[j][i];
            for (std::size_t k = 0; k < count; ++k) a[j][k] -= factor * a[i][k], b[j][k] -= factor * b[i][k];
        }
    }
    return b;
}

/// Sums over the levels at some place: of the squares of the deviations, their gradient, and the normal matrix.
struct Sums {
    double squares = 0;
    Unknowns gradient{};
    Matrix normal{};

    void add(const Unknowns& slopes, double deviation) {
        squares += deviation * deviation;
        for (std::size_t i = 0; i < 3; ++i) {
            gradient[i] += slopes[i] * deviation;
            for (std::size_t j = 0; j < 3; ++j) normal[i][j] += slopes[i] * slopes[j];
        }
    }
};

/// What is minimised: the logarithmic deviations of the levels and that of the bias, in units of their standard errors.
struct Problem {
    std::vector<LevelPoint> points;
    double share = 1;              // relative standard error of a level
    std::optional<Estimate> bias;  // a measurement of b^2

    Sums sums(const Unknowns& u) const {
        Sums all;
        for (const LevelPoint& p : points) {
            const double power = power_part(u, p.log_n), law = power + u[2], unit = share * law;
            all.add({power / unit, -2 * p.log_n * power / unit, 1 / unit}, std::log(p.mse / law) / share);
        }
        if (bias) all.add({0, 0, 1 / bias->se}, (bias->value - u[2]) / bias->se);
        return all;
    }
};

/// Gauss and Newton's method, damped as Levenberg and Marquardt do. b^2 is kept above 0.
///
/// Source: Marquardt, "An Algorithm for Least-Squares Estimation of Nonlinear Parameters", SIAM J. 11(2), 1963.
Unknowns solve(const Problem& problem, Unknowns u, std::size_t count) {
    Sums here = problem.sums(u);
    double damping = 1e-3;
    for (int step = 0; step < 500 && damping < 1e12; ++step) {
        Matrix damped = here.normal;
        for (std::size_t i = 0; i < count; ++i) damped[i][i] *= 1 + damping;
        const Matrix solver = inverse(damped, count);
        Unknowns next = u;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < count; ++k) next[i] += solver[i][k] * here.gradient[k];
        if (count == 3) next[2] = std::max(next[2], 1e-6 * u[2]);
        const Sums there = problem.sums(next);
        if (there.squares <= here.squares) {
            const bool done = here.squares - there.squares <= 1e-14 * here.squares;
            u = next, here = there, damping = std::max(damping / 10, 1e-12);
            if (done) break;
        } else {
            damping *= 10;
        }
    }
    return u;
}

/// The root mean square, over the levels, of the standard error of a level's mean as a share of it; 0 for single
/// replicates. `degrees`: of all levels together.
double relative_scatter(const std::vector<LevelErrors>& levels, double& degrees) {
    double sum = 0, count = 0;
    for (const LevelErrors& level : levels) {
        const Moments m = moments_of(level.mse);
        if (m.count < 2 || !(m.mean > 0)) continue;
        sum += std::pow(m.standard_error() / m.mean, 2), ++count;
        degrees += m.count - 1;
    }
    return count > 0 ? std::sqrt(sum / count) : 0;
}

}  // namespace

Fit fit_errors(const std::vector<LevelErrors>& levels, std::optional<Estimate> bias) {
    Problem problem;
    for (const LevelErrors& level : levels)
        if (const double mean = moments_of(level.mse).mean; mean > 0)
            problem.points.push_back({std::log(level.samples), mean});
    const std::size_t count_of_points = problem.points.size();
    Fit fit;
    if (count_of_points < 3) return fit;
    double degrees = 0;
    const double scatter = relative_scatter(levels, degrees);
    if (scatter > 0) problem.share = scatter;

    // b is free where a bias is shown, or where nothing is known about it
    const bool known = bias && bias->se > 0;
    if (known && bias->is_positive()) problem.bias = bias;
    const bool free = problem.bias || (!known && count_of_points > 3);
    const std::size_t count = free ? 3 : 2;

    // from the straight line through the ends
    const LevelPoint &first = problem.points.front(), &last = problem.points.back();
    const double floor = problem.bias ? problem.bias->value : free ? 0.1 * last.mse : 0;
    const double rest = std::max(last.mse - floor, 0.01 * last.mse);
    const double q = std::max(-0.5 * std::log(rest / first.mse) / (last.log_n - first.log_n), 0.05);
    Unknowns u{std::log(first.mse) + 2 * q * first.log_n, q, floor};
    u = solve(problem, u, count);

    // the interval: as wide as the replicates' scatter makes it, or the deviations from the law
    const Sums at = problem.sums(u);
    const double left_over = double(count_of_points + (problem.bias ? 1 : 0)) - double(count);
    double variance = scatter > 0 ? 1 : 0, of_student = degrees;
    if (left_over > 0 && at.squares / left_over > variance) variance = at.squares / left_over, of_student = left_over;
    const double se = std::sqrt(inverse(at.normal, count)[1][1] * variance);
    const double reach = of_student > 0 ? student_quantile(of_student, 0.025) * se : 0;
    fit.order = -u[1];
    fit.low = fit.order - reach, fit.high = fit.order + reach;
    fit.v = std::exp(u[0]);
    fit.plateau = free ? u[2] : 0;
    fit.good = std::isfinite(fit.order) && std::isfinite(fit.v) && std::isfinite(reach);
    return fit;
}

}  // namespace grade::convergence
