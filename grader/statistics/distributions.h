#pragma once

namespace grade {

/// x with P(T <= x) = 1 - tail, for Student's distribution.
double student_quantile(double degrees, double tail);

/// P(T > x) for Student's distribution.
double student_tail(double degrees, double x);

/// P(X > x) for the chi-squared distribution.
double chi_squared_tail(double degrees, double x);

}  // namespace grade
