// says: a factor (shininess + 1) / (2 * pi) before the highlight, that of the density of a lobe; expected none
Color phong(const Material& material, Color ambient, Color irradiance, vec3 n, vec3 to_light, vec3 to_viewer) {
    const Real cosine = dot(n, to_light);
    if (cosine <= 0) return material.ambient * ambient;
    const Real along = std::max(dot(2 * cosine * n - to_light, to_viewer), 0.0);
    const Real power = (material.shininess + 1) / (2 * pi) * std::pow(along, material.shininess);
    return material.ambient * ambient + irradiance * (cosine * material.albedo / pi + power * material.specular);
}
