Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const Real r = std::sqrt(u.x);
    const Real phi = 2 * pi * u.y;
    const Real z = std::sqrt(1 - u.x);
    const Frame frame = frame_about(n);
    return {r * std::cos(phi) * frame.x + r * std::sin(phi) * frame.y + z * n, albedo};
}
