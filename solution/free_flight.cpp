#include "rt/fragments.h"

namespace rt {

/// How far light travels in a homogeneous medium before it meets something.
///
///     density s exp(-s t),    so    t = -log(1 - u) / s
///
/// extinction  s > 0 [1/m]
/// u           random number, 0 <= u < 1
/// returns     distance [m]
/// blank       inf: the medium is clear
///
/// Source: Kalos and Whitlock, "Monte Carlo Methods", chapter 6.
Real free_flight(Real extinction, Real u) {
    // BEGIN SOLUTION
    return -log1p(-u) / extinction;
    // END SOLUTION: return not_started(inf);
}

}  // namespace rt
