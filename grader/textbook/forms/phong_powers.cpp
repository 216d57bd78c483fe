Color phong(const Material& material, Color ambient, Color irradiance, vec3 n, vec3 to_light, vec3 to_viewer) {
    const Real diffuse = std::max(dot(n, to_light), 0.0) / pi;
    const Real along = dot(2 * dot(n, to_light) * n - to_light, to_viewer);
    const bool is_lit = dot(n, to_light) > 0;
    const Real power = is_lit && along > 0 ? std::pow(along, material.shininess) : 0.0;
    const Color glow = material.ambient * ambient;
    return glow + irradiance * diffuse * material.albedo + irradiance * power * material.specular;
}
