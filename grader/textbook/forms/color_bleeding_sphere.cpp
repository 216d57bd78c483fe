Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const Real z = 1 - 2 * u.x;
    const Real r = safe_sqrt(1 - z * z);
    const Real phi = 2 * pi * u.y;
    const vec3 on_sphere = vec3(r * std::cos(phi), r * std::sin(phi), z);
    return {unit(n + on_sphere), albedo};
}
