vec3 mirror_direction(vec3 d, vec3 n) {
    const Real along = d.x * n.x + d.y * n.y + d.z * n.z;
    return {d.x - 2 * along * n.x, d.y - 2 * along * n.y, d.z - 2 * along * n.z};
}
