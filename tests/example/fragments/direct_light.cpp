#include "rt/fragments.h"

namespace rt {

/// What one sample of a light with extent adds to the radiance of a surface, unless something is in between.
///
///     (r_d max(0, n . d) + r_s max(0, r . c)^a) L / density,    r = 2 (n . d) n - d,    r_d = albedo / pi
///
/// as in phong, with L / density in place of the irradiance of a surface that faces the light; nothing where n . d <=
/// 0.
///
/// material   albedo, specular r_s and shininess a
/// radiance   L of the light [W/(sr m2)]
/// light      a sample of it: unit direction d [world] and density [1/sr]; density 0: nothing arrives
/// n          unit normal, on the viewer's side [world]
/// to_viewer  c, unit direction to the viewer [world]
/// returns    radiance [W/(sr m2)]
/// blank      0
///
/// Source: Shirley and Wang, "Monte Carlo Techniques for Direct Lighting Calculations", ACM TOG 15(1), 1996.
Color direct_light(const Material& material, Color radiance, const LightSample& light, vec3 n, vec3 to_viewer) {
    if (light.density == 0) return Color(0);
    Material without_ambient = material;
    without_ambient.ambient = Color(0);
    return phong(without_ambient, Color(0), radiance / light.density, n, light.direction, to_viewer);
}

}  // namespace rt
