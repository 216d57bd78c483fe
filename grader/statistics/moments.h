#pragma once

#include <span>

namespace grade {

/// Mean and central moments of a set of numbers, updated one number at a time or by joining two sets; no sum of squares
/// is ever formed, so a small variance about a large mean stays exact.
///
/// Source: Pébay, "Formulas for Robust, One-Pass Parallel Computation of Covariances and Arbitrary-Order Statistical
/// Moments", Sandia report SAND2008-6212, 2008.
struct Moments {
    double count = 0;
    double mean = 0;
    double m2 = 0, m3 = 0, m4 = 0;  // sums of (x - mean)^k

    void add(double x);
    void join(const Moments& other);

    double variance() const;        // unbiased; 0 for fewer than two numbers
    double deviation() const;       // its square root
    double standard_error() const;  // of the mean
    double kurtosis() const;        // m4 count / m2^2: 3 for a normal distribution
};

Moments moments_of(std::span<const double> values);

}  // namespace grade
