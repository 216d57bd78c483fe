#include "rt/fragments.h"

namespace rt {

/// The radiance that a surface reflects, by Phong's model.
///
///     L = r_a I_a + r_d H max(0, n . d) + r_s H max(0, r . c)^a,    r = 2 (n . d) n - d,    r_d = albedo / pi
///
/// and no highlight where the light is below the horizon, n . d <= 0.
///
/// material    ambient r_a, albedo, specular r_s and shininess a
/// ambient     I_a [W/(sr m2)]
/// irradiance  H of a surface that faces the light [W/m2]
/// n           unit normal, on the viewer's side [world]
/// to_light    d, unit direction to the light [world]
/// to_viewer   c, unit direction to the viewer [world]
/// returns     radiance [W/(sr m2)]
/// blank       irradiance x albedo / pi: as if each surface faced the light
///
/// A large a magnifies the rounding of r . c, which is close to 1 in the highlight. 1 - r . c = |r - c|^2/2 has all its
/// digits: (r . c)^a = exp(a log1p(-|r - c|^2/2)).
///
/// Source: Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975; Kahan,
/// "How Futile are Mindless Assessments of Roundoff", 2006, on angles between vectors.
Color phong(const Material& material, Color ambient, Color irradiance, vec3 n, vec3 to_light, vec3 to_viewer) {
    // BEGIN SOLUTION
    const Color glow = material.ambient * ambient;
    const Real cosine = dot(n, to_light);
    if (!(cosine > 0)) return glow;
    const vec3 mirrored = 2 * cosine * n - to_light;
    const vec3 apart = mirrored - to_viewer;
    const Real off = dot(apart, apart) / 2;  // 1 - r . c
    const Real highlight = off < 1 ? exp(material.shininess * log1p(-off)) : 0;
    return glow + irradiance * (cosine / pi * material.albedo + highlight * material.specular);
    // END SOLUTION: return not_started(irradiance * material.albedo / pi);
}

}  // namespace rt
