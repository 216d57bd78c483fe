#include "statistics/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace grade {

namespace {

// 53 bits are enough, and several times faster than the long double that Boost would take for the way there
using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Student = boost::math::students_t_distribution<double, Policy>;
using ChiSquaredLaw = boost::math::chi_squared_distribution<double, Policy>;

}  // namespace

double student_quantile(double degrees, double tail) {
    return boost::math::quantile(boost::math::complement(Student(degrees), tail));
}

double student_tail(double degrees, double x) {
    return boost::math::cdf(boost::math::complement(Student(degrees), x));
}

double chi_squared_tail(double degrees, double x) {
    return boost::math::cdf(boost::math::complement(ChiSquaredLaw(degrees), x));
}

}  // namespace grade
