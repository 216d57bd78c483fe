// says: sine and cosine exchanged in the direction: a ring about the axis
DirectionSample phong_lobe(Real exponent, vec2 u) {
    const Real cosine = std::pow(u.x, 1 / (exponent + 1));
    const Real sine = safe_sqrt(1 - cosine * cosine);
    const Real phi = 2 * pi * u.y;
    const Real density = (exponent + 1) / (2 * pi) * std::pow(cosine, exponent);
    return {{cosine * std::cos(phi), cosine * std::sin(phi), sine}, density};
}
