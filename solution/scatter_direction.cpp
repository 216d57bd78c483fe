#include "rt/fragments.h"

namespace rt {

/// The direction of light after it is scattered in a medium, by the phase function of Henyey and Greenstein.
///
///     density = (1 - g^2) / (4 pi (1 + g^2 - 2 g c)^(3/2)),    c = cosine of the angle between old and new direction
///
/// With s = 2 u.x - 1 the cosine is (2 s + g (3 + s^2) + 2 g^2 s + g^3 (s^2 - 1)) / (2 (1 + g s)^2), which is s for g =
/// 0: all directions alike. Close to |g| = 1 all light is within a tiny angle of d or -d: there 1 - c, or 1 + c, has
/// the digits,
///
///     1 - c = 2 (1 - u.x) (1 + g u.x) ((1 - g)/(1 - g + 2 g u.x))^2,    1 + g^2 - 2 g c = (1 - g)^2 + 2 g (1 - c)
///
/// Another map of the square with this density is as good.
///
/// d        unit direction of travel [world]
/// g        mean cosine, -1 < g < 1
/// u        random point of the unit square, 0 <= u < 1
/// returns  unit direction [world] and its density [1/sr]
/// blank    straight on
///
/// Source: Henyey and Greenstein, "Diffuse Radiation in the Galaxy", Astrophysical Journal 93, 1941.
DirectionSample scatter_direction(vec3 d, Real g, vec2 u) {
    // BEGIN SOLUTION
    // How far from the peak, which is at d, or at -d where g < 0.
    const Real h = std::abs(g), v = g < 0 ? 1 - u.x : u.x;
    const Real k = 2 * (1 - v) * (1 + h * v) * sqr((1 - h) / (1 - h + 2 * h * v));
    const Real cosine = g < 0 ? k - 1 : 1 - k, sine = safe_sqrt(k * (2 - k));
    const vec2 circle = unit_circle(u.y);
    const Real lengthened = sqr(1 - h) + 2 * h * k;
    return {frame_about(d).to_world({sine * circle.x, sine * circle.y, cosine}),
            (1 - h) * (1 + h) / (4 * pi * lengthened * std::sqrt(lengthened))};
    // END SOLUTION: return not_started(DirectionSample{d, 1 / (4 * pi)});
}

}  // namespace rt
