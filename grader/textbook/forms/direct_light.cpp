Color direct_light(const Material& material, Color radiance, const LightSample& light, vec3 n, vec3 to_viewer) {
    const Real cosine = dot(n, light.direction);
    if (cosine <= 0 || light.density <= 0) return Color(0);
    const vec3 r = 2 * cosine * n - light.direction;
    const Color diffuse = cosine * material.albedo / pi;
    const Color highlight = std::pow(std::max(dot(r, to_viewer), 0.0), material.shininess) * material.specular;
    return (diffuse + highlight) * radiance / light.density;
}
