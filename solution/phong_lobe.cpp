#include "rt/fragments.h"

namespace rt {

/// A direction about z, with the density of a Phong lobe.
///
///     density = (n + 1)/(2 pi) cos(alpha)^n,    so    cos(alpha) = u.x^(1/(n+1)),    phi = 2 pi u.y
///
/// Another map of the square with this density is as good.
///
/// exponent  n >= 0; a narrow lobe for a large one
/// u         random point of the unit square, 0 <= u < 1
/// returns   unit direction, alpha its angle to the z axis, and its density [1/sr]
/// blank     the z axis
///
/// For a large n the sine drowns in 1 - cos^2: with l = log(u.x)/(n + 1) the cosine is exp(l) and the squared sine
/// -expm1(2 l). cos^n is cos^(n+1)/cos = u.x/cos.
///
/// Source: Lafortune and Willems, "Using the Modified Phong Reflectance Model", TR CW197, 1994; Higham,
/// "Accuracy and Stability of Numerical Algorithms", 2nd ed., sections 1.7 and 1.14.
DirectionSample phong_lobe(Real exponent, vec2 u) {
    // BEGIN SOLUTION
    const Real l = log(u.x) / (exponent + 1);
    const Real cosine = exp(l), sine = safe_sqrt(-expm1(2 * l));
    const vec2 circle = unit_circle(u.y);
    const Real to_the_n = u.x > 0 ? u.x / cosine : exponent > 0 ? 0 : 1;
    const Real density = (exponent + 1) / (2 * pi) * to_the_n;
    return {{sine * circle.x, sine * circle.y, cosine}, density};
    // END SOLUTION: return not_started(DirectionSample{{0, 0, 1}, 1 / pi});
}

}  // namespace rt
