DiskSample uniform_disk(vec2 u) {
    const Real x = 2 * u.x - 1;
    const Real y = 2 * u.y - 1;
    if (x == 0 && y == 0) return {vec2(0), 1 / pi};
    Real r = x;
    Real phi = pi / 4 * (y / x);
    if (std::abs(x) <= std::abs(y)) {
        r = y;
        phi = pi / 2 - pi / 4 * (x / y);
    }
    return {{r * std::cos(phi), r * std::sin(phi)}, 1 / pi};
}
