#include "statistics/moments.h"

#include <cmath>

namespace grade {

void Moments::add(double x) {
    Moments one;
    one.count = 1;
    one.mean = x;
    join(one);
}

void Moments::join(const Moments& other) {
    if (other.count == 0) return;
    if (count == 0) {
        *this = other;
        return;
    }
    const double a = count, b = other.count, n = a + b;
    const double d = other.mean - mean, dn = d / n;

    m4 += other.m4 + d * dn * dn * dn * a * b * (a * a - a * b + b * b) +
          6 * dn * dn * (a * a * other.m2 + b * b * m2) + 4 * dn * (a * other.m3 - b * m3);
    m3 += other.m3 + d * dn * dn * a * b * (a - b) + 3 * dn * (a * other.m2 - b * m2);
    m2 += other.m2 + d * dn * a * b;
    mean += dn * b;
    count = n;
}

double Moments::variance() const { return count > 1 ? m2 / (count - 1) : 0; }

double Moments::deviation() const { return std::sqrt(variance()); }

double Moments::standard_error() const { return count > 0 ? std::sqrt(variance() / count) : 0; }

double Moments::kurtosis() const { return m2 > 0 ? m4 * count / (m2 * m2) : 0; }

Moments moments_of(std::span<const double> values) {
    Moments result;
    for (double x : values) result.add(x);
    return result;
}

}  // namespace grade
