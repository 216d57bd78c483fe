// says: u.x * cos(theta_max) as the cosine: also directions outside of the cone
DirectionSample sphere_cone(Real sine, vec2 u) {
    const Real cos_max = safe_sqrt(1 - sine * sine);
    const Real c = u.x * cos_max;
    const Real s = safe_sqrt(1 - c * c);
    const Real phi = 2 * pi * u.y;
    return {{s * std::cos(phi), s * std::sin(phi), c}, 1 / (2 * pi * (1 - cos_max))};
}
