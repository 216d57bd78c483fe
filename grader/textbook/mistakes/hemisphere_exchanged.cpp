// says, reordered: the sine over pi as the density: the cosine is the z of the direction, if that is not exchanged
DirectionSample cosine_hemisphere(vec2 u) {
    const Real sine = std::sqrt(u.x);
    const Real cosine = std::sqrt(1 - u.x);
    const Real phi = 2 * pi * u.y;
    return {{cosine * std::cos(phi), cosine * std::sin(phi), sine}, cosine / pi};
}
