// says: the power of specular * cosine; expected specular times the power of the cosine alone
Color phong(const Material& material, Color ambient, Color irradiance, vec3 n, vec3 to_light, vec3 to_viewer) {
    const Real cosine = dot(n, to_light);
    if (cosine <= 0) return material.ambient * ambient;
    const Real along = std::max(dot(2 * cosine * n - to_light, to_viewer), 0.0);
    const Color k = along * material.specular;
    const Real a = material.shininess;
    const Color shine = Color(std::pow(k.x, a), std::pow(k.y, a), std::pow(k.z, a));
    return material.ambient * ambient + irradiance * (cosine * material.albedo / pi + shine);
}
