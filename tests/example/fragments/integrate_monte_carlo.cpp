#include "rt/fragments.h"

namespace rt {

/// The integral of f by Monte Carlo with importance sampling.
///
///     1/N sum_i w_i f(x_i),    w_i = 1/Q(x_i)
///
/// f        the integrand
/// density  Q, the probability density from which the x_i were drawn; positive at each of them
/// x        the N sample points; none gives 0
/// returns  the estimate, with an error of O(1/sqrt(N)); none at all where Q is proportional to f
/// blank    0
///
/// Source: Kalos and Whitlock, "Monte Carlo Methods", chapter 4.
Real integrate_monte_carlo(const Function& f, const Function& density, std::span<const Real> x) {
    if (x.size() == 0) return 0;
    double sum = 0;
    for (size_t i = 0; i < x.size(); i++) sum += 1 / density(x[i]) * f(x[i]);
    return sum / x.size();
}

}  // namespace rt
