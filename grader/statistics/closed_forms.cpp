#include "statistics/closed_forms.h"

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <complex>

namespace grade {

double quad_irradiance(const rt::Quad& quad, rt::vec3 p, rt::vec3 n) {
    const std::array<rt::vec3, 4> corners = {quad.center - quad.u - quad.v, quad.center + quad.u - quad.v,
                                             quad.center + quad.u + quad.v, quad.center - quad.u + quad.v};
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        const rt::vec3 a = rt::unit(corners[i] - p), b = rt::unit(corners[(i + 1) % 4] - p);
        const rt::vec3 normal = rt::cross(a, b);
        const double sine = std::sqrt(rt::dot(normal, normal));
        sum += std::atan2(sine, rt::dot(a, b)) * rt::dot(normal, n) / sine;
    }
    return std::abs(sum) / 2;
}

double coaxial_disc_irradiance(double radius, double height) {
    return rt::pi * rt::sqr(radius) / (rt::sqr(radius) + rt::sqr(height));
}

double sphere_irradiance(const rt::Sphere& sphere, rt::vec3 p, rt::vec3 n) {
    const rt::vec3 to_center = sphere.center - p;
    return rt::pi * rt::sqr(sphere.radius) / rt::dot(to_center, to_center) * rt::dot(rt::unit(to_center), n);
}

double phong_albedo(double exponent, double angle) { return phong_moment(exponent, angle, 0); }

/// In polar coordinates (a, f) about the axis, the cosine at the surface is cos t cos a - sin t sin a cos f, t the
/// angle of the axis. Its positive part integrates over f in closed form.
double phong_moment(double exponent, double angle, double k) {
    using rt::pi;
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

namespace {

/// The mean of exp(i rate x^2) between low and high.
std::complex<double> mean_of_axis(double rate, double low, double high) {
    const auto part = [=](double (*f)(double)) {
        return boost::math::quadrature::gauss<double, 30>::integrate([=](double x) { return f(rate * x * x); }, low,
                                                                     high) /
               (high - low);
    };
    return {part([](double x) { return std::cos(x); }), part([](double x) { return std::sin(x); })};
}

}  // namespace

double zone_plate(double rate, rt::vec2 p) { return (1 + std::cos(rate * rt::dot(p, p))) / 2; }

double zone_plate_mean(double rate, const rt::Extent& pixel) {
    const auto x = mean_of_axis(rate, pixel.low.x, pixel.high.x), y = mean_of_axis(rate, pixel.low.y, pixel.high.y);
    return (1 + (x * y).real()) / 2;
}

}  // namespace grade
