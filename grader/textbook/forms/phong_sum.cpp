Color phong(const Material& material, Color ambient, Color irradiance, vec3 n, vec3 to_light, vec3 to_viewer) {
    Color color = material.ambient * ambient;
    const Real cosine = std::max(dot(n, to_light), 0.0);
    color += irradiance * material.albedo / pi * cosine;
    const vec3 r = 2 * dot(n, to_light) * n - to_light;
    const Real along = std::max(dot(r, to_viewer), 0.0);
    if (cosine > 0) color += irradiance * material.specular * std::pow(along, material.shininess);
    return color;
}
