#include "rt/fragments.h"

namespace rt {

/// The integral of f over [a, b] from n regular points.
///
///     D/n sum_i f(x_i),    D = b - a,    x_i = a + (i + 1/2) D/n,    i = 0 ... n-1
///
/// f        the integrand
/// a, b     the interval; b < a gives the integral its sign
/// n        number of points, > 0
/// returns  the estimate, with an error of O(1/n^2) where f is smooth
/// blank    0
///
/// Source: the midpoint rule; Davis and Rabinowitz, "Methods of Numerical Integration", section 2.1.
Real integrate_uniform(const Function& f, Real a, Real b, int n) {
    double sum = 0;
    double h = (b - a) / n;
    double x = a + h / 2;
    for (int i = 0; i < n; i++) {
        sum += f(x);
        x += h;
    }
    return sum * h;
}

}  // namespace rt
