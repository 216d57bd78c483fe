// says: a turn by 2 * theta, with theta between d and the normal; expected a turn by pi - 2 * theta
vec3 mirror_direction(vec3 d, vec3 n) {
    const Real c = dot(d, n);
    const Real share = c * c / dot(d, d);
    return (4 * share - 1) * (d - c * n) + (4 * share - 3) * c * n;
}
