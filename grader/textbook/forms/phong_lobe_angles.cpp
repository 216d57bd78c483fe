DirectionSample phong_lobe(Real exponent, vec2 u) {
    const Real alpha = std::acos(std::pow(u.x, 1 / (exponent + 1)));
    const Real phi = 2 * pi * u.y;
    const Real density = (exponent + 1) / (2 * pi) * std::pow(std::cos(alpha), exponent);
    return {{std::sin(alpha) * std::cos(phi), std::sin(alpha) * std::sin(phi), std::cos(alpha)}, density};
}
