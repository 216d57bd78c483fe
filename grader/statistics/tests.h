#pragma once

#include <span>

#include "statistics/moments.h"

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

/// The difference of two means whose variances may differ.
struct Welch {
    double difference;  // of the means, a - b
    double se;          // its standard error
    double degrees;     // of Student's distribution, by Welch and Satterthwaite
    double t;           // difference / se; 0 when both are 0
    double p;           // two-sided
};

/// Source: Welch, "The generalization of 'Student's' problem when several different population variances are involved",
/// Biometrika 34, 1947.
Welch welch_test(const Moments& a, const Moments& b);

}  // namespace grade
