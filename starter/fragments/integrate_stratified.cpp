#include "rt/fragments.h"

namespace rt {

/// The integral of f over a union of intervals, each with random points of its own.
///
///     sum_t d_t/N_t sum_j f(x_tj),    d_t = high_t - low_t,    x_tj = low_t + u_tj d_t
///
/// f        the integrand
/// strata   T intervals that do not overlap, each with N_t random numbers u_tj in [0, 1); an empty one adds nothing
/// returns  the estimate, with an error of O(T^-3/2) for one number a stratum where f is smooth
/// blank    0
///
/// Source: Cook, "Stochastic Sampling in Computer Graphics", ACM TOG 5(1), 1986.
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    // YOUR CODE HERE
    return not_started(Real(0));
}

}  // namespace rt
