Color phong(const Material& material, Color ambient, Color irradiance, vec3 n, vec3 to_light, vec3 to_viewer) {
    const Real cosine = dot(n, to_light);
    if (cosine <= 0) return material.ambient * ambient;
    const vec3 r = 2 * cosine * n - to_light;
    const Real highlight = std::pow(std::max(dot(r, to_viewer), 0.0), material.shininess);
    return material.ambient * ambient + irradiance * (cosine * material.albedo / pi + highlight * material.specular);
}
