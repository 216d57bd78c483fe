#pragma once

#include "rt/math.h"

namespace rt {

/// Share of the light that a scattering turns from d to w, per solid angle [1/sr]: Henyey and Greenstein's phase
/// function. Nobody needs this file for the assignment.
inline Real phase(vec3 d, vec3 w, Real g) {
    const vec3 off = g < 0 ? d + w : d - w;  // from the peak: its square has more digits than d . w
    const Real h = std::abs(g), k = sqr(1 - h) + h * dot(off, off);
    return (1 - h) * (1 + h) / (4 * pi * k * std::sqrt(k));
}

}  // namespace rt
