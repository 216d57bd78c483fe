Color direct_light(const Material& material, Color radiance, const LightSample& light, vec3 n, vec3 to_viewer) {
    if (light.density <= 0) return Color(0);
    const Real cosine = dot(n, light.direction);
    if (cosine <= 0) return Color(0);
    const Color irradiance = radiance / light.density;
    const vec3 r = 2 * cosine * n - light.direction;
    const Real along = std::max(dot(r, to_viewer), 0.0);
    return irradiance * cosine * material.albedo / pi +
           irradiance * material.specular * std::pow(along, material.shininess);
}
