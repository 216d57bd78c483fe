// says: the mirror direction turned round: mirror_direction takes a direction of travel, -to_light
Color phong(const Material& material, Color ambient, Color irradiance, vec3 n, vec3 to_light, vec3 to_viewer) {
    const Real cosine = dot(n, to_light);
    if (cosine <= 0) return material.ambient * ambient;
    const Real along = std::max(dot(to_light - 2 * cosine * n, to_viewer), 0.0);
    const Color reflected = cosine * material.albedo / pi + std::pow(along, material.shininess) * material.specular;
    return material.ambient * ambient + irradiance * reflected;
}
