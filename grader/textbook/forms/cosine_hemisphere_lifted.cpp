DirectionSample cosine_hemisphere(vec2 u) {
    const Real r = std::sqrt(u.x);
    const Real phi = 2 * pi * u.y;
    const Real x = r * std::cos(phi);
    const Real y = r * std::sin(phi);
    const Real z = safe_sqrt(1 - x * x - y * y);
    return {{x, y, z}, z / pi};
}
