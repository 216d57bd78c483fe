// says: directions uniform on the hemisphere, whatever the exponent is, with the density of the lobe
DirectionSample phong_lobe(Real exponent, vec2 u) {
    const Real cosine = u.x;
    const Real sine = safe_sqrt(1 - cosine * cosine);
    const Real phi = 2 * pi * u.y;
    return {{sine * std::cos(phi), sine * std::sin(phi), cosine},
            (exponent + 1) / (2 * pi) * std::pow(cosine, exponent)};
}
