#include "rt/fragments.h"

namespace rt {

/// The Monte Carlo estimate of a pixel from its samples.
///
///     1/n sum_i w_i L_i
///
/// radiance  L_i of the n samples, linear, of any size [W/(sr m2)]; n > 0
/// weight    w_i, one for each
/// returns   the mean [W/(sr m2)]
/// blank     the first sample
///
/// Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    // BEGIN SOLUTION
    Sum red, green, blue;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        red.add(weight[i] * radiance[i].x);
        green.add(weight[i] * radiance[i].y);
        blue.add(weight[i] * radiance[i].z);
    }
    return Color(red.value(), green.value(), blue.value()) / Real(radiance.size());
    // END SOLUTION: return not_started(radiance[0]);
}

}  // namespace rt
