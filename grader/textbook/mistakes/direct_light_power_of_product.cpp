// says: the power of specular * cosine; expected specular times the power of the cosine alone
Color direct_light(const Material& material, Color radiance, const LightSample& light, vec3 n, vec3 to_viewer) {
    const Real cosine = dot(n, light.direction);
    if (cosine <= 0 || light.density <= 0) return Color(0);
    const Real along = std::max(dot(2 * cosine * n - light.direction, to_viewer), 0.0);
    const Color k = along * material.specular;
    const Real a = material.shininess;
    const Color shine = Color(std::pow(k.x, a), std::pow(k.y, a), std::pow(k.z, a));
    return (cosine * material.albedo / pi + shine) * radiance / light.density;
}
