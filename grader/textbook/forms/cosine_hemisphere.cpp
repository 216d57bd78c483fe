DirectionSample cosine_hemisphere(vec2 u) {
    const Real sine = std::sqrt(u.x);
    const Real cosine = std::sqrt(1 - u.x);
    const Real phi = 2 * pi * u.y;
    return {{sine * std::cos(phi), sine * std::sin(phi), cosine}, cosine / pi};
}
