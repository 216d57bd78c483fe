DirectionSample cosine_hemisphere(vec2 u) {
    const Real theta = 0.5 * std::acos(1 - 2 * u.x);
    const Real phi = 2 * pi * u.y;
    return {{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}, std::cos(theta) / pi};
}
