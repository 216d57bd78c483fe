#include "statistics/convergence.h"

#include <algorithm>
#include <cmath>

#include "statistics/regression.h"

namespace grade {

double error_slope(std::span<const double> samples, std::span<const double> errors) {
    const double largest = errors.empty() ? 0 : *std::ranges::max_element(errors);
    if (largest == 0) return 0;
    std::vector<double> cut;
    for (const double error : errors) cut.push_back(std::max(error, 1e-9 * largest));
    return log_log_slope(samples, cut).value;
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
