#pragma once

#include <span>
#include <vector>

namespace grade {

/// The coefficients b that make |y - X b| smallest.
///
/// rows     X, one row an observation, all as long; a constant term is a column of ones
/// returns  one coefficient a column. Throws std::invalid_argument when the columns are dependent or the rows too few.
std::vector<double> least_squares(const std::vector<std::vector<double>>& rows, std::span<const double> y);

struct Line {
    double intercept, slope;
};

/// The straight line through points.
Line fit_line(std::span<const double> x, std::span<const double> y);

/// The slope of log y against log x: the exponent of y = c x^slope.
double log_log_slope(std::span<const double> x, std::span<const double> y);

/// Slope of log error against log N: error = c N^slope. Errors below 1e-9 of the largest count as that, so that points
/// without any error have a slope as well, of 0 where none has one.
///
///     independent points   -1/2
///     one in each of N squares: a smooth function -1, an edge at an angle to the axes -3/4
///     one in each of N intervals, a smooth function   -3/2
///     the middles of N intervals, a smooth function   -2
///     a bias, a rounded sum    0, as soon as N is large enough
///
/// Source: Mitchell, "Consequences of Stratified Sampling in Graphics", SIGGRAPH 1996; Ramamoorthi et al., "A Theory of
/// Monte Carlo Visibility Sampling", ACM TOG 31(5), 2012.
double error_slope(std::span<const double> samples, std::span<const double> errors);

/// Root of the mean square of errors.
double root_mean_square(std::span<const double> errors);

/// The levels 1, 4, 16 ... 4^(count - 1).
std::vector<int> levels(int count);

}  // namespace grade
