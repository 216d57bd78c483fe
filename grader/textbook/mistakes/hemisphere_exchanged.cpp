// says, reordered: sine and cosine exchanged, in direction or density; expected the density z / pi, with the z returned
DirectionSample cosine_hemisphere(vec2 u) {
    const Real sine = std::sqrt(u.x);
    const Real cosine = std::sqrt(1 - u.x);
    const Real phi = 2 * pi * u.y;
    return {{cosine * std::cos(phi), cosine * std::sin(phi), sine}, cosine / pi};
}
