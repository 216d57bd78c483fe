// says: directions of the sphere turned up to n, with the density of the whole sphere, 1 / (4 * pi)
Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const Real z = 1 - 2 * u.x;
    const Real r = safe_sqrt(1 - z * z);
    const Real phi = 2 * pi * u.y;
    const vec3 on_sphere = vec3(r * std::cos(phi), r * std::sin(phi), z);
    const vec3 direction = dot(on_sphere, n) < 0 ? -on_sphere : on_sphere;
    return {direction, 4 * dot(direction, n) * albedo};
}
