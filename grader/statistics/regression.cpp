#include "statistics/regression.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace grade {

namespace {

/// A matrix, column by column.
class Columns {
public:
    Columns(std::size_t height, std::size_t width) : height_(height), values_(height * width, 0.0) {}
    double& operator()(std::size_t row, std::size_t column) { return values_[column * height_ + row]; }

private:
    std::size_t height_;
    std::vector<double> values_;
};

}  // namespace

/// By Gram and Schmidt's X = Q R, columns of Q orthonormal: R b = Q' y.
std::vector<double> least_squares(const std::vector<std::vector<double>>& rows, std::span<const double> y) {
    const std::size_t n = rows.size(), p = n > 0 ? rows[0].size() : 0;
    if (n <= p || y.size() != n) throw std::invalid_argument("least squares: fewer observations than unknowns");

    // Q R
    Columns q(n, p), r(p, p);
    for (std::size_t j = 0; j < p; ++j) {
        double before = 0, after = 0;
        for (std::size_t i = 0; i < n; ++i) q(i, j) = rows[i][j], before += q(i, j) * q(i, j);
        for (int twice = 0; twice < 2; ++twice)  // a second pass removes what rounding left
            for (std::size_t k = 0; k < j; ++k) {
                double shared = 0;
                for (std::size_t i = 0; i < n; ++i) shared += q(i, k) * q(i, j);
                for (std::size_t i = 0; i < n; ++i) q(i, j) -= shared * q(i, k);
                r(k, j) += shared;
            }
        for (std::size_t i = 0; i < n; ++i) after += q(i, j) * q(i, j);
        if (!(after > 1e-20 * before)) throw std::invalid_argument("least squares: dependent columns");
        r(j, j) = std::sqrt(after);
        for (std::size_t i = 0; i < n; ++i) q(i, j) /= r(j, j);
    }

    std::vector<double> projection(p, 0), rest(y.begin(), y.end());
    for (std::size_t j = 0; j < p; ++j) {
        for (std::size_t i = 0; i < n; ++i) projection[j] += q(i, j) * rest[i];
        for (std::size_t i = 0; i < n; ++i) rest[i] -= projection[j] * q(i, j);
    }

    // from the last one up
    std::vector<double> b(p);
    for (std::size_t j = p; j-- > 0;) {
        double value = projection[j];
        for (std::size_t k = j + 1; k < p; ++k) value -= r(j, k) * b[k];
        b[j] = value / r(j, j);
    }
    return b;
}

Line fit_line(std::span<const double> x, std::span<const double> y) {
    std::vector<std::vector<double>> rows;
    for (double value : x) rows.push_back({1, value});
    const std::vector<double> b = least_squares(rows, y);
    return {b[0], b[1]};
}

double log_log_slope(std::span<const double> x, std::span<const double> y) {
    std::vector<double> log_x, log_y;
    for (double value : x) log_x.push_back(std::log(value));
    for (double value : y) log_y.push_back(std::log(value));
    return fit_line(log_x, log_y).slope;
}

double error_slope(std::span<const double> samples, std::span<const double> errors) {
    const double largest = errors.empty() ? 0 : *std::ranges::max_element(errors);
    if (largest == 0) return 0;
    std::vector<double> cut;
    for (const double error : errors) cut.push_back(std::max(error, 1e-9 * largest));
    return log_log_slope(samples, cut);
}

double root_mean_square(std::span<const double> errors) {
    double sum = 0;
    for (const double error : errors) sum += error * error;
    return errors.empty() ? 0 : std::sqrt(sum / double(errors.size()));
}

std::vector<int> levels(int count) {
    std::vector<int> all;
    for (int k = 0, n = 1; k < count; ++k, n *= 4) all.push_back(n);
    return all;
}

}  // namespace grade
