// says: a turn by 2 * theta, with theta between d and the normal; expected a turn by pi - 2 * theta
vec3 mirror_direction(vec3 d, vec3 n) {
    const Real c = dot(d, n);
    const vec3 along = d - c * n;
    if (dot(along, along) < 1e-12 * dot(d, d)) return -d;
    const Real share = c * c / dot(d, d);
    return (4 * share - 1) * along + (4 * share - 3) * c * n;
}
