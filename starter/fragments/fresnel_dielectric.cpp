#include "rt/fragments.h"

namespace rt {

/// The share of unpolarised light that a smooth boundary between two dielectrics reflects.
///
///     F = (s^2 + p^2) / 2,    s = (e1 c1 - e2 c2) / (e1 c1 + e2 c2),    p = (e2 c1 - e1 c2) / (e2 c1 + e1 c2)
///     c2 = sqrt(1 - (e1/e2)^2 (1 - c1^2))
///
/// cosine    c1, of the angle between the ray and the normal, 0 to 1
/// ior_from  e1, index of refraction on the side that the ray comes from
/// ior_to    e2, index of refraction on the other side
/// returns   F, 0 to 1; 1 at total internal reflection; 0 for equal indices
/// blank     0
///
/// Near the critical angle and at grazing incidence 1 - c1^2 loses the digits that matter: take
/// (e2 c2)^2 = (e2 - e1)(e2 + e1) + (e1 c1)^2.
///
/// Source: Born and Wolf, "Principles of Optics", section 1.5; Higham,
/// "Accuracy and Stability of Numerical Algorithms", 2nd ed., section 1.7.
Real fresnel_dielectric(Real cosine, Real ior_from, Real ior_to) {
    // YOUR CODE HERE
    return not_started(Real(0));
}

}  // namespace rt
