// says: a factor (shininess + 1) / (2 * pi) before the highlight, that of the density of a lobe; expected none
Color direct_light(const Material& material, Color radiance, const LightSample& light, vec3 n, vec3 to_viewer) {
    const Real cosine = dot(n, light.direction);
    if (cosine <= 0 || light.density <= 0) return Color(0);
    const Real along = std::max(dot(2 * cosine * n - light.direction, to_viewer), 0.0);
    const Real power = (material.shininess + 1) / (2 * pi) * std::pow(along, material.shininess);
    return (cosine * material.albedo / pi + power * material.specular) * radiance / light.density;
}
