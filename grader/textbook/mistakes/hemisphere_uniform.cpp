// says: u.x as the cosine, or 1 - u.x: directions uniform on the hemisphere; expected its root, sqrt(u.x)
DirectionSample cosine_hemisphere(vec2 u) {
    const Real z = u.x;
    const Real r = safe_sqrt(1 - z * z);
    const Real phi = 2 * pi * u.y;
    return {{r * std::cos(phi), r * std::sin(phi), z}, z / pi};
}
