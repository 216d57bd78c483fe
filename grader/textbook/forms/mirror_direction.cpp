vec3 mirror_direction(vec3 d, vec3 n) {
    const Real along = dot(d, n);
    return d - 2 * along * n;
}
