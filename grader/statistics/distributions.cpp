#include "statistics/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>
#include <utility>

namespace grade {

namespace {

// 53 bits are enough, and several times faster than the long double that Boost would take for the way there
using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Student = boost::math::students_t_distribution<double, Policy>;
using ChiSquaredLaw = boost::math::chi_squared_distribution<double, Policy>;

}  // namespace

double student_quantile(double degrees, double tail) {
    const auto solve = [&] { return boost::math::quantile(boost::math::complement(Student(degrees), tail)); };
    // the same few looks ask for the same few quantiles again and again; Welch's degrees are never the same
    if (degrees != std::floor(degrees)) return solve();
    thread_local std::map<std::pair<double, double>, double> known;
    const auto [entry, is_new] = known.try_emplace({degrees, tail});
    if (is_new) entry->second = solve();
    return entry->second;
}

double student_tail(double degrees, double x) { return boost::math::cdf(boost::math::complement(Student(degrees), x)); }

double chi_squared_tail(double degrees, double x) {
    return boost::math::cdf(boost::math::complement(ChiSquaredLaw(degrees), x));
}

}  // namespace grade
