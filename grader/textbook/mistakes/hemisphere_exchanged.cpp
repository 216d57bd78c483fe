// says, reordered: sine and cosine exchanged, in the direction or in the density; expected its z, over pi, as the density
DirectionSample cosine_hemisphere(vec2 u) {
    const Real sine = std::sqrt(u.x);
    const Real cosine = std::sqrt(1 - u.x);
    const Real phi = 2 * pi * u.y;
    return {{cosine * std::cos(phi), cosine * std::sin(phi), sine}, cosine / pi};
}
