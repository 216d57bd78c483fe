// says: the sine taken for the tangent of the half angle: cos(theta_max) = 1 / sqrt(1 + sine^2), not sqrt(1 - sine^2)
DirectionSample sphere_cone(Real sine, vec2 u) {
    const Real cos_max = 1 / std::sqrt(1 + sine * sine);
    const Real c = 1 - u.x * (1 - cos_max);
    const Real s = safe_sqrt(1 - c * c);
    const Real phi = 2 * pi * u.y;
    return {{s * std::cos(phi), s * std::sin(phi), c}, 1 / (2 * pi * (1 - cos_max))};
}
