#pragma once

#include <optional>
#include <vector>

#include "statistics/error.h"

namespace grade::convergence {

/// The errors of all pictures of one number of samples.
struct LevelErrors {
    double samples = 0;
    std::vector<double> mse;  // of each replicate; one: a pattern without randomness
};

/// How the mean squared error falls with the number of samples:
///
///     MSE(N) = b^2 + v N^(-2q)
struct Fit {
    double order = 0;          // -q: slope of the RMSE against N on logarithmic axes
    double low = 0, high = 0;  // its 95 % interval
    double v = 0;
    double plateau = 0;  // b^2; 0 where none is shown
    bool good = false;   // false: too few levels with an error above 0
};

/// By Gauss and Newton's method on logarithmic deviations, all levels alike, since an MSE over a picture scatters by a
/// share of itself. The interval comes from the covariance of the fit and Student's distribution: with the scatter of
/// the replicates, or, where the levels deviate from the law by more than that, with their own.
///
/// bias  of the same pictures, which is the law's value at N = infinity: used where it is above 0 by more than chance,
///       else b = 0. None: b is a free number, where there are levels enough
Fit fit_errors(const std::vector<LevelErrors>& levels, std::optional<Estimate> bias);

}  // namespace grade::convergence
