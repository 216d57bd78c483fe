#pragma once

#include <span>
#include <vector>

namespace grade {

/// The level of each of `tests` tests that together reject a true hypothesis with probability at most alpha.
inline double bonferroni(double alpha, int tests) { return tests > 0 ? alpha / tests : alpha; }

/// Which hypotheses to reject so that a true one is among them with probability at most alpha; rejects all that
/// Bonferroni does, and more.
///
/// Source: Holm, "A simple sequentially rejective multiple test procedure", Scand. J. Statistics 6, 1979.
std::vector<bool> holm(std::span<const double> p, double alpha);

}  // namespace grade
