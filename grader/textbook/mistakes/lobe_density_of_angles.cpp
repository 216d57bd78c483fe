// says: the density over theta and phi, with the sine of theta; expected that per solid angle, without
DirectionSample phong_lobe(Real exponent, vec2 u) {
    const DirectionSample right = phong_lobe(exponent, u);
    const vec3 d = right.direction;
    return {d, std::sqrt(d.x * d.x + d.y * d.y) * right.density};
}
