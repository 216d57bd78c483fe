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
/// Source: Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975.
Color phong(const Material& material, Color ambient, Color irradiance, vec3 n, vec3 to_light, vec3 to_viewer) {
    Color l = material.ambient * ambient;
    double n_d = dot(n, to_light);
    if (n_d > 0) {
        l += irradiance * material.albedo / pi * n_d;
        vec3 r = 2.0 * n_d * n - to_light;
        l += irradiance * material.specular * std::pow(std::max(0.0, dot(r, to_viewer)), material.shininess);
    }
    return l;
}

}  // namespace rt
