DirectionSample scatter_direction(vec3 d, Real g, vec2 u) {
    Real c = 1 - 2 * u.x;
    if (std::abs(g) > 1e-3) {
        const Real q = (1 - g * g) / (1 + g - 2 * g * u.x);
        c = (1 + g * g - q * q) / (2 * g);
    }
    const Real s = safe_sqrt(1 - c * c);
    const Real phi = 2 * pi * u.y;
    const vec3 direction = frame_about(d).to_world({s * std::cos(phi), s * std::sin(phi), c});
    const Real density = 1 / (4 * pi) * (1 - g * g) / std::pow(1 + g * g - 2 * g * c, 1.5);
    return {direction, density};
}
