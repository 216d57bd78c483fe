DirectionSample phong_lobe(Real exponent, vec2 u) {
    const Real cosine = std::pow(u.x, 1 / (exponent + 1));
    const Real sine = std::sqrt(1 - cosine * cosine);
    const Real phi = 2 * pi * u.y;
    return {{sine * std::cos(phi), sine * std::sin(phi), cosine},
            (exponent + 1) / (2 * pi) * std::pow(cosine, exponent)};
}
