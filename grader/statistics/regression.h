#pragma once

#include <span>
#include <vector>

namespace grade {

/// A coefficient of a fit, with its standard error.
struct Coefficient {
    double value = 0, se = 0;
    int degrees = 0;

    /// Half of the interval that holds the true value with the given probability.
    double reach(double confidence) const;
};

/// The coefficients b that make |y - X b| smallest.
///
/// rows     X, one row an observation, all as long; a constant term is a column of ones
/// returns  one coefficient a column. Throws std::invalid_argument when the columns are dependent or the rows too few.
std::vector<Coefficient> least_squares(const std::vector<std::vector<double>>& rows, std::span<const double> y);

struct Line {
    Coefficient intercept, slope;
};

/// The straight line through points.
Line fit_line(std::span<const double> x, std::span<const double> y);

/// The slope of log y against log x: the exponent of y = c x^slope.
Coefficient log_log_slope(std::span<const double> x, std::span<const double> y);

}  // namespace grade
