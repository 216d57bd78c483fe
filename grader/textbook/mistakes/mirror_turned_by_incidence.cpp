// says: a turn by 2 * theta, with theta between d and the normal; expected by pi - 2 * theta
vec3 mirror_direction(vec3 d, vec3 n) {
    const Real c = dot(d, n);
    return 2 * c * n - d;
}
