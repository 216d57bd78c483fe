// says: 1 - cos as 2 * (sine / 2)^2: it is the angle that is halved, not its sine
DirectionSample sphere_cone(Real sine, vec2 u) {
    const Real m = sine * sine / 2;
    const Real c = 1 - u.x * m;
    const Real s = safe_sqrt(1 - c * c);
    const Real phi = 2 * pi * u.y;
    return {{s * std::cos(phi), s * std::sin(phi), c}, 1 / (2 * pi * m)};
}
