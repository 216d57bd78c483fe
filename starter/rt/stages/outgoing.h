#pragma once

#include "rt/fragments.h"
#include "rt/stages/stages.h"

namespace rt {

/// What leaves the surface of lane i towards the viewer, and with which weights.
inline Outgoing outgoing(const Material& m, const Batch& b, const Surfaces& s, int i) {
    Real fresnel = 0;
    if (m.transmittance != Color(0)) {
        const Real cosine = -dot(b.direction.at(i), s.normal(i));
        fresnel = s.behind[i] ? fresnel_dielectric(cosine, m.ior, 1) : fresnel_dielectric(cosine, 1, m.ior);
    }
    return whitted(m, fresnel);
}

}  // namespace rt
