#include "protocol/rows.h"

#include <cmath>
#include <stdexcept>

namespace grade {

double Integrand::operator()(double x) const {
    const auto at = [&](std::size_t i) { return parameters.at(i); };
    switch (kind) {
        case Kind::polynomial: {
            double sum = 0;
            for (std::size_t i = parameters.size(); i-- > 0;) sum = sum * x + parameters[i];
            return sum;
        }
        case Kind::gaussian:
            return at(0) * std::exp(-rt::sqr((x - at(1)) / at(2)) / 2);
        case Kind::lorentzian:
            return at(0) / (1 + rt::sqr((x - at(1)) / at(2)));
        case Kind::cosine:
            return at(0) + at(1) * std::cos(2 * rt::pi * at(2) * x + at(3));
        case Kind::exponential:
            return at(0) * std::exp(-at(1) * x);
        case Kind::power:
            return at(0) * std::pow(x, at(1));
        case Kind::step:
            return x < at(0) ? at(1) : at(2);
    }
    throw std::domain_error("an integrand of an unknown kind");
}

double RowReader::number() {
    if (rest.empty()) throw std::out_of_range("the row is too short");
    const double x = rest.front();
    rest = rest.subspan(1);
    return x;
}

std::size_t RowReader::count() {
    const double n = number();
    if (!(n >= 0 && n <= double(rest.size()) && n == std::floor(n))) throw std::domain_error("a count is no count");
    return std::size_t(n);
}

int RowReader::whole() {
    const double x = number();
    if (!(x >= -2147483648.0 && x <= 2147483647.0)) throw std::domain_error("a whole number is none");
    return int(x);
}

}  // namespace grade
