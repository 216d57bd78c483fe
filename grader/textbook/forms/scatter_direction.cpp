DirectionSample scatter_direction(vec3 d, Real g, vec2 u) {
    const Real squared = (1 - g * g) / (1 - g + 2 * g * u.x);
    const Real c = std::abs(g) < 1e-3 ? 2 * u.x - 1 : (1 + g * g - squared * squared) / (2 * g);
    const Real s = safe_sqrt(1 - c * c);
    const Real phi = 2 * pi * u.y;
    const vec3 direction = frame_about(d).to_world({s * std::cos(phi), s * std::sin(phi), c});
    const Real below = 1 + g * g - 2 * g * c;
    return {direction, (1 - g * g) / (4 * pi * below * std::sqrt(below))};
}
