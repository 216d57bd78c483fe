// says: cos(u.x * theta_max) as the cosine: uniform in the angle; expected 1 - u.x * (1 - cos(theta_max))
DirectionSample sphere_cone(Real sine, vec2 u) {
    const Real cos_max = safe_sqrt(1 - sine * sine);
    const Real theta = u.x * std::asin(sine);
    const Real phi = 2 * pi * u.y;
    return {{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)},
            1 / (2 * pi * (1 - cos_max))};
}
