// says: the density over theta and phi, with the sine of theta; expected that per solid angle, without
DirectionSample scatter_direction(vec3 d, Real g, vec2 u) {
    const DirectionSample right = scatter_direction(d, g, u);
    return {right.direction, length(cross(d, right.direction)) * right.density};
}
