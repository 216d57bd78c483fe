#include "rt/fragments.h"

namespace rt {

/// Which rays leave a hit, and with which weights.
///
///     opaque:  local 1,  mirror reflectance,              glass 0
///     glass:   local 1,  mirror fresnel x reflectance,    glass (1 - fresnel) x transmittance
///
/// material  reflectance and transmittance; it is glass where any channel of the transmittance is positive
/// fresnel   share of the light that the surface reflects, from fresnel_dielectric
/// returns   weights of the light that the surface scatters itself, of the mirrored and of the refracted ray; a ray
///           with weight 0 is not traced
/// blank     local light alone
///
/// Source: Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980.
Outgoing whitted(const Material& material, Real fresnel) {
    Outgoing out;
    out.local = Color(1);
    out.mirror = material.reflectance;
    out.glass = Color(0);
    if (material.transmittance != Color(0)) {
        out.mirror *= fresnel;
        out.glass = (1 - fresnel) * material.transmitance;
    }
    return out;
}

}  // namespace rt
