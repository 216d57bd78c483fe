// says: the density over theta and phi, with the sine of theta; expected that per solid angle, z / pi
DirectionSample cosine_hemisphere(vec2 u) {
    const DirectionSample right = cosine_hemisphere(u);
    const vec3 d = right.direction;
    return {d, std::sqrt(d.x * d.x + d.y * d.y) * right.density};
}
