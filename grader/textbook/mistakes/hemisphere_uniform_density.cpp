// says: u.x as the cosine: directions uniform on the hemisphere, and their density 1 / (2 * pi)
DirectionSample cosine_hemisphere(vec2 u) {
    const Real z = u.x;
    const Real r = safe_sqrt(1 - z * z);
    const Real phi = 2 * pi * u.y;
    return {{r * std::cos(phi), r * std::sin(phi), z}, 1 / (2 * pi)};
}
