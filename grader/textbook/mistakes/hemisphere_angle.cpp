// says: theta = u.x * pi / 2, uniform in the angle; expected a cosine whose square is uniform, sqrt(u.x)
DirectionSample cosine_hemisphere(vec2 u) {
    const Real theta = u.x * pi / 2;
    const Real phi = 2 * pi * u.y;
    return {{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}, std::cos(theta) / pi};
}
