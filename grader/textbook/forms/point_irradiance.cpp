Color point_irradiance(const PointLight& light, vec3 p, vec3 n) {
    const vec3 d = light.directional ? light.position : light.position - p;
    const Real distance2 = light.directional ? 1.0 : dot(d, d);
    const Real cosine = dot(n, unit(d));
    return light.intensity * std::max(cosine, 0.0) / distance2;
}
