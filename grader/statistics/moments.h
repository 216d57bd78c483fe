#pragma once

#include <span>

namespace grade {

/// Mean and variance of a set of numbers, updated one number at a time; no sum of squares is ever formed, so a small
/// variance about a large mean stays exact.
///
/// Source: Welford, "Note on a Method for Calculating Corrected Sums of Squares and Products", Technometrics 4(3),
/// 1962.
struct Moments {
    double count = 0;
    double mean = 0;
    double m2 = 0;  // sum of (x - mean)^2

    void add(double x);

    double variance() const;        // unbiased; 0 for fewer than two numbers
    double deviation() const;       // its square root
    double standard_error() const;  // of the mean
};

Moments moments_of(std::span<const double> values);

}  // namespace grade
