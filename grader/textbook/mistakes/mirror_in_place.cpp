// says: a d that is changed component by component, so that dot(d, n) is no longer that of the given d
vec3 mirror_direction(vec3 d, vec3 n) {
    const vec3 x = vec3(d.x - 2 * dot(d, n) * n.x, d.y, d.z);
    const vec3 y = vec3(x.x, x.y - 2 * dot(x, n) * n.y, x.z);
    return vec3(y.x, y.y, y.z - 2 * dot(y, n) * n.z);
}
