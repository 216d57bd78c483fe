#include "rt/fragments.h"

namespace rt {

/// What one sample of a light with extent adds to the radiance of a surface, unless something is in between.
///
///     (r_d max(0, n . d) + r_s max(0, r . c)^a) L / density,    r = 2 (n . d) n - d,    r_d = albedo / pi
///
/// as in phong, with L / density in place of the irradiance of a surface that faces the light; nothing where
/// n . d <= 0.
///
/// material   albedo, specular r_s and shininess a
/// radiance   L of the light [W/(sr m2)]
/// light      a sample of it: unit direction d [world] and density [1/sr]; density 0: nothing arrives
/// n          unit normal, on the viewer's side [world]
/// to_viewer  c, unit direction to the viewer [world]
/// returns    radiance [W/(sr m2)]
/// blank      0
///
/// A large a magnifies the rounding of r . c, which is close to 1 in the highlight. 1 - r . c = |r - c|^2/2 has all its
/// digits: (r . c)^a = exp(a log1p(-|r - c|^2/2)).
///
/// Source: Shirley and Wang, "Monte Carlo Techniques for Direct Lighting Calculations", ACM TOG 15(1), 1996; Kahan,
/// "How Futile are Mindless Assessments of Roundoff", 2006, on angles between vectors.
Color direct_light(const Material& material, Color radiance, const LightSample& light, vec3 n, vec3 to_viewer) {
    // YOUR CODE HERE
    return not_started(Color(0));
}

}  // namespace rt
