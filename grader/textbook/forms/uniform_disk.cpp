DiskSample uniform_disk(vec2 u) {
    const Real r = std::sqrt(u.x);
    const Real phi = 2 * pi * u.y;
    return {{r * std::cos(phi), r * std::sin(phi)}, 1 / pi};
}
