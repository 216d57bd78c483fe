// says: the density of a disk, 1 / (pi * sine^2); expected that of the solid angle, 1 / (2 * pi * (1 - cos(theta_max)))
DirectionSample sphere_cone(Real sine, vec2 u) {
    const Real cos_max = safe_sqrt(1 - sine * sine);
    const Real c = 1 - u.x * (1 - cos_max);
    const Real s = safe_sqrt(1 - c * c);
    const Real phi = 2 * pi * u.y;
    return {{s * std::cos(phi), s * std::sin(phi), c}, 1 / (pi * sine * sine)};
}
