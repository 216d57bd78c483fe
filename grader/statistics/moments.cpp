#include "statistics/moments.h"

#include <cmath>

namespace grade {

void Moments::add(double x) {
    ++count;
    if (count == 1) {
        mean = x;
        return;
    }
    const double d = x - mean, dn = d / count;
    m2 += d * dn * (count - 1);
    mean += dn;
}

double Moments::variance() const { return count > 1 ? m2 / (count - 1) : 0; }

double Moments::deviation() const { return std::sqrt(variance()); }

double Moments::standard_error() const { return count > 0 ? std::sqrt(variance() / count) : 0; }

Moments moments_of(std::span<const double> values) {
    Moments result;
    for (double x : values) result.add(x);
    return result;
}

}  // namespace grade
