Color point_irradiance(const PointLight& light, vec3 p, vec3 n) {
    if (light.directional) return light.intensity * std::max(dot(n, unit(light.position)), 0.0);
    const vec3 to_light = light.position - p;
    const Real distance = glm::length(to_light);
    const vec3 d = to_light / distance;
    return light.intensity * std::max(dot(n, d), 0.0) / (distance * distance);
}
