#pragma once

#include <string>
#include <vector>

#include "calibration/replay.h"

namespace grade::calibration {

/// How a statistic's t-test keeps its promise on the solution's replicates: a statistic that is normal enough rejects
/// the truth as often as alpha says.
struct Nominal {
    std::string check, what;
    double at_2 = 0, at_3 = 0;  // observed over nominal rate of rejection, at 1e-2 and 1e-3
    double bias = 0;            // |mean - truth| over delta: how far the solution itself is from the closed form
    double tilt = 0;    // |mean - truth| - delta0, in its standard errors; above 4 the truth or delta0 is in doubt
    double spread = 0;  // of a replicate, over delta
};

/// For each statistic of one grading seed whose noise is more than rounding.
///
/// draws  tests of each, of 16 replicates: the fewest that a failure may rest on
std::vector<Nominal> nominal_rates(const PooledChecks& checks, int draws, std::uint64_t random);

}  // namespace grade::calibration
