#pragma once

#include <optional>
#include <span>

namespace grade::convergence {

/// Where a curve of error against time passes: one level of one replicate.
struct Waypoint {
    double samples, seconds, mse;
};

/// A positive number with its 95 % interval; low = high = value where there is but one measurement.
struct Ratio {
    double value = 0, low = 0, high = 0;
};

/// How far beyond the levels that were measured a curve is taken to go on as it ends.
constexpr double most_extrapolation = 4;

/// The MSE after so much CPU time, on straight lines between the levels on logarithmic axes. None: too far beyond them.
std::optional<double> mse_at(std::span<const Waypoint> path, double seconds);

/// The CPU time to such an MSE; likewise. None, too, where the error has stopped falling above it.
std::optional<double> seconds_for(std::span<const Waypoint> path, double mse);

/// The geometric mean of measurements, with Student's interval of their logarithms. None of none.
std::optional<Ratio> geometric_mean(std::span<const double> values);

}  // namespace grade::convergence
