Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const Real z = u.x;
    const Real r = safe_sqrt(1 - z * z);
    const Real phi = 2 * pi * u.y;
    const vec3 direction = frame_about(n).to_world({r * std::cos(phi), r * std::sin(phi), z});
    return {direction, 2 * z * albedo};
}
