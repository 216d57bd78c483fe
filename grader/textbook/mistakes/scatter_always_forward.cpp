// says: the peak at d also where g < 0: there it must be at -d
DirectionSample scatter_direction(vec3 d, Real g, vec2 u) {
    const Real h = std::abs(g);
    const Real v = g < 0 ? 1 - u.x : u.x;
    const Real squared = (1 - h * h) / (1 - h + 2 * h * v);
    const Real c = h < 1e-3 ? 2 * v - 1 : (1 + h * h - squared * squared) / (2 * h);
    const Real s = safe_sqrt(1 - c * c);
    const Real phi = 2 * pi * u.y;
    const Real below = 1 + h * h - 2 * h * c;
    return {frame_about(d).to_world({s * std::cos(phi), s * std::sin(phi), c}),
            (1 - h * h) / (4 * pi * below * std::sqrt(below))};
}
