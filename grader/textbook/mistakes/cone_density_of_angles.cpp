// says: the density over theta and phi, with the sine of theta; expected that per solid angle, without
DirectionSample sphere_cone(Real sine, vec2 u) {
    const DirectionSample right = sphere_cone(sine, u);
    const vec3 d = right.direction;
    return {d, std::sqrt(d.x * d.x + d.y * d.y) * right.density};
}
