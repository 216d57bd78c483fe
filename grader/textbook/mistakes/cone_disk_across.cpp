// says: a uniform point of the disk across the cone, raised to the sphere: directions that are not uniform
DirectionSample sphere_cone(Real sine, vec2 u) {
    const Real cos_max = safe_sqrt(1 - sine * sine);
    const Real r = std::sqrt(u.x) * sine;
    const Real phi = 2 * pi * u.y;
    return {{r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - r * r)}, 1 / (2 * pi * (1 - cos_max))};
}
