// says: the directions of cosine_hemisphere, whatever the exponent is, with the density of the lobe
DirectionSample phong_lobe(Real exponent, vec2 u) {
    const vec3 direction = cosine_hemisphere(u).direction;
    return {direction, (exponent + 1) / (2 * pi) * std::pow(direction.z, exponent)};
}
