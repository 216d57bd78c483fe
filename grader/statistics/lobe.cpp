#include "statistics/lobe.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

namespace grade {

double phong_albedo(double exponent, double angle) { return phong_moment(exponent, angle, 0); }

/// In polar coordinates (a, f) about the axis, the cosine at the surface is cos t cos a - sin t sin a cos f, t the
/// angle of the axis. Its positive part integrates over f in closed form.
double phong_moment(double exponent, double angle, double k) {
    using std::numbers::pi;
    const auto ring = [&](double a) {
        const double p = std::cos(angle) * std::cos(a), q = std::sin(angle) * std::sin(a);
        const double half = p >= q ? pi : std::acos(-p / q);  // where the cosine is positive: |f - pi| < half
        const double cosines = 2 * (half * p + q * std::sin(half));
        return std::pow(std::cos(a), exponent + k) * std::sin(a) * cosines;
    };
    // the ring touches the horizon at pi/2 - angle: integrate on either side of that kink
    const double kink = pi / 2 - angle;
    using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
    const double sum = Rule::integrate(ring, 0.0, kink, 12, 1e-13) + Rule::integrate(ring, kink, pi / 2, 12, 1e-13);
    return (exponent + 2) / (2 * pi) * sum;
}

double lobe_dispersion(double exponent) { return 1 / ((exponent + 1) * (exponent + 3)); }

}  // namespace grade
