#pragma once

#include <span>

namespace grade {

struct ChiSquared {
    double statistic = 0;
    int degrees = 0;  // 0: nothing to compare
    double p = 1;     // probability of a statistic at least as large
};

/// Pearson's test of counts against what a density expects of them. Bins that expect fewer than `least` counts are
/// pooled, smallest first, until the pool expects as many; a count where nothing can fall gives p = 0.
///
///     sum (observed - expected)^2 / expected  ~  chi squared with (pooled bins - 1) degrees
///
/// observed, expected  one entry a bin, equal totals
ChiSquared chi_squared_test(std::span<const double> observed, std::span<const double> expected, double least = 5);

}  // namespace grade
