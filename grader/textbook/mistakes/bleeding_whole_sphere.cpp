// says: directions uniform on the hemisphere, with the density of the whole sphere, 1 / (4 * pi)
Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const Real z = u.x;
    const Real r = safe_sqrt(1 - z * z);
    const Real phi = 2 * pi * u.y;
    return {frame_about(n).to_world({r * std::cos(phi), r * std::sin(phi), z}), 4 * z * albedo};
}
