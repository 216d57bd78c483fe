// says: sine and cosine exchanged in the direction: a ring about the axis
DirectionSample sphere_cone(Real sine, vec2 u) {
    const Real cos_max = safe_sqrt(1 - sine * sine);
    const Real c = 1 - u.x * (1 - cos_max);
    const Real s = safe_sqrt(1 - c * c);
    const Real phi = 2 * pi * u.y;
    return {{c * std::cos(phi), c * std::sin(phi), s}, 1 / (2 * pi * (1 - cos_max))};
}
