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
    Color sum(0);
    for (size_t i = 0; i < radiance.size(); i++) sum += weight[i] * radiance[i];
    return min(sum / double(radiance.size()), Color(1));  // no overexposed pixels
}

}  // namespace rt
