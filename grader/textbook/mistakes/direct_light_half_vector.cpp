// says: dot(n, h), with the half vector h = unit(d + c), in place of dot(r, c)
Color direct_light(const Material& material, Color radiance, const LightSample& light, vec3 n, vec3 to_viewer) {
    const Real cosine = dot(n, light.direction);
    if (cosine <= 0 || light.density <= 0) return Color(0);
    const Real along = std::max(dot(n, unit(light.direction + to_viewer)), 0.0);
    const Color reflected = cosine * material.albedo / pi + std::pow(along, material.shininess) * material.specular;
    return reflected * radiance / light.density;
}
