#include "statistics/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace grade {

double student_quantile(double degrees, double tail) {
    return boost::math::quantile(boost::math::complement(boost::math::students_t(degrees), tail));
}

double student_tail(double degrees, double x) {
    return boost::math::cdf(boost::math::complement(boost::math::students_t(degrees), x));
}

double chi_squared_tail(double degrees, double x) {
    return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), x));
}

}  // namespace grade
