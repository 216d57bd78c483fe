vec3 mirror_direction(vec3 d, vec3 n) {
    const Real x = (1 - 2 * n.x * n.x) * d.x - 2 * n.x * n.y * d.y - 2 * n.x * n.z * d.z;
    const Real y = -2 * n.y * n.x * d.x + (1 - 2 * n.y * n.y) * d.y - 2 * n.y * n.z * d.z;
    const Real z = -2 * n.z * n.x * d.x - 2 * n.z * n.y * d.y + (1 - 2 * n.z * n.z) * d.z;
    return {x, y, z};
}
