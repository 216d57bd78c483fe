#include "statistics/welch.h"

#include <cmath>

#include "statistics/distributions.h"

namespace grade {

Welch welch_test(const Moments& a, const Moments& b) {
    const double va = a.variance() / a.count, vb = b.variance() / b.count, v = va + vb;
    Welch result{a.mean - b.mean, std::sqrt(v), a.count + b.count - 2, 0, 1};
    if (v > 0) {
        result.degrees = v * v / (va * va / (a.count - 1) + vb * vb / (b.count - 1));
        result.t = result.difference / result.se;
        result.p = 2 * student_tail(result.degrees, std::abs(result.t));
    } else if (result.difference != 0) {
        result.t = std::copysign(INFINITY, result.difference);
        result.p = 0;
    }
    return result;
}

}  // namespace grade
