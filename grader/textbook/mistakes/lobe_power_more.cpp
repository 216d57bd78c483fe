// says: cos^(exponent + 1), which is u.x, in the density; expected cos^exponent, u.x / cosine
DirectionSample phong_lobe(Real exponent, vec2 u) {
    return {phong_lobe(exponent, u).direction, (exponent + 1) / (2 * pi) * u.x};
}
