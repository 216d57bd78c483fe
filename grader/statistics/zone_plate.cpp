#include "statistics/zone_plate.h"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>

namespace grade {

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
