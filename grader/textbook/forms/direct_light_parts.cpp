Color direct_light(const Material& material, Color radiance, const LightSample& light, vec3 n, vec3 to_viewer) {
    const Real diffuse = std::max(dot(n, light.direction), 0.0) / pi;
    const Real along = dot(2 * dot(n, light.direction) * n - light.direction, to_viewer);
    const bool is_lit = dot(n, light.direction) > 0 && light.density > 0;
    if (!is_lit) return Color(0);
    const Real power = along > 0 ? std::pow(along, material.shininess) : 0.0;
    const Color first = radiance * diffuse * material.albedo / light.density;
    const Color second = radiance * power * material.specular / light.density;
    return first + second;
}
