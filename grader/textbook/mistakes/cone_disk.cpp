// says: a uniform point of a disk as wide as the cone, 1 above its tip: directions that are not uniform
DirectionSample sphere_cone(Real sine, vec2 u) {
    const Real cos_max = safe_sqrt(1 - sine * sine);
    const Real r = std::sqrt(u.x) * sine / cos_max;
    const Real phi = 2 * pi * u.y;
    const vec3 direction = unit(vec3(r * std::cos(phi), r * std::sin(phi), 1.0));
    return {direction, 1 / (2 * pi * (1 - cos_max))};
}
