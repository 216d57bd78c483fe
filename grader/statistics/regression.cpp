#include "statistics/regression.h"

#include <cmath>
#include <stdexcept>

#include "statistics/distributions.h"

namespace grade {

double Coefficient::reach(double confidence) const {
    return se > 0 ? student_quantile(degrees, (1 - confidence) / 2) * se : 0;
}

/// By Gram and Schmidt's X = Q R, columns of Q orthonormal: R b = Q' y, and the covariance of b is s^2 (R' R)^-1.
std::vector<Coefficient> least_squares(const std::vector<std::vector<double>>& rows, std::span<const double> y) {
    const std::size_t n = rows.size(), p = n > 0 ? rows[0].size() : 0;
    if (n <= p || y.size() != n) throw std::invalid_argument("least squares: fewer observations than unknowns");

    // Q R
    std::vector<std::vector<double>> q(p, std::vector<double>(n)), r(p, std::vector<double>(p, 0));
    for (std::size_t j = 0; j < p; ++j) {
        double before = 0, after = 0;
        for (std::size_t i = 0; i < n; ++i) q[j][i] = rows[i][j], before += q[j][i] * q[j][i];
        for (int twice = 0; twice < 2; ++twice)  // a second pass removes what rounding left
            for (std::size_t k = 0; k < j; ++k) {
                double shared = 0;
                for (std::size_t i = 0; i < n; ++i) shared += q[k][i] * q[j][i];
                for (std::size_t i = 0; i < n; ++i) q[j][i] -= shared * q[k][i];
                r[k][j] += shared;
            }
        for (double x : q[j]) after += x * x;
        if (!(after > 1e-20 * before)) throw std::invalid_argument("least squares: dependent columns");
        r[j][j] = std::sqrt(after);
        for (double& x : q[j]) x /= r[j][j];
    }

    // residuals
    std::vector<double> projection(p, 0), rest(y.begin(), y.end());
    for (std::size_t j = 0; j < p; ++j) {
        for (std::size_t i = 0; i < n; ++i) projection[j] += q[j][i] * rest[i];
        for (std::size_t i = 0; i < n; ++i) rest[i] -= projection[j] * q[j][i];
    }
    double squares = 0;
    for (double x : rest) squares += x * x;
    const int degrees = int(n - p);

    // b and the rows of R^-1, from the last one up
    std::vector<Coefficient> b(p);
    std::vector<std::vector<double>> inverse(p, std::vector<double>(p, 0));
    for (std::size_t j = p; j-- > 0;) {
        double value = projection[j];
        inverse[j][j] = 1;
        for (std::size_t k = j + 1; k < p; ++k) {
            value -= r[j][k] * b[k].value;
            for (std::size_t m = k; m < p; ++m) inverse[j][m] -= r[j][k] * inverse[k][m];
        }
        double length = 0;
        for (double& x : inverse[j]) x /= r[j][j], length += x * x;
        b[j] = {value / r[j][j], std::sqrt(length * squares / degrees), degrees};
    }
    return b;
}

Line fit_line(std::span<const double> x, std::span<const double> y) {
    std::vector<std::vector<double>> rows;
    for (double value : x) rows.push_back({1, value});
    const std::vector<Coefficient> b = least_squares(rows, y);
    return {b[0], b[1]};
}

Coefficient log_log_slope(std::span<const double> x, std::span<const double> y) {
    std::vector<double> log_x, log_y;
    for (double value : x) log_x.push_back(std::log(value));
    for (double value : y) log_y.push_back(std::log(value));
    return fit_line(log_x, log_y).slope;
}

}  // namespace grade
