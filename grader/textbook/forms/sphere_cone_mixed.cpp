DirectionSample sphere_cone(Real sine, vec2 u) {
    const Real cos_max = safe_sqrt(1 - sine * sine);
    const Real c = u.x * cos_max + 1 - u.x;
    const Real theta = std::acos(c);
    const Real phi = 2 * pi * u.y;
    return {{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)},
            1 / (2 * pi * (1 - cos_max))};
}
