#pragma once

#include "statistics/moments.h"

namespace grade {

/// The difference of two means whose variances may differ.
struct Welch {
    double difference;  // of the means, a - b
    double se;          // its standard error
    double degrees;     // of Student's distribution, by Welch and Satterthwaite
    double t;           // difference / se; 0 when both are 0
    double p;           // two-sided
};

/// Source: Welch, "The generalization of 'Student's' problem when several different population variances are involved",
/// Biometrika 34, 1947.
Welch welch_test(const Moments& a, const Moments& b);

}  // namespace grade
