// says: directions uniform on the sphere, whatever g is, and the density that these would have with g
DirectionSample scatter_direction(vec3 d, Real g, vec2 u) {
    const Real c = 1 - 2 * u.x;
    const Real s = safe_sqrt(1 - c * c);
    const Real phi = 2 * pi * u.y;
    const Real below = 1 + g * g - 2 * g * c;
    const vec3 direction = frame_about(d).to_world({s * std::cos(phi), s * std::sin(phi), c});
    return {direction, (1 - g * g) / (4 * pi * std::pow(below, 1.5))};
}
