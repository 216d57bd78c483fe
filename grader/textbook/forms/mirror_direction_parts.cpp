vec3 mirror_direction(vec3 d, vec3 n) {
    const vec3 normal_part = dot(d, n) * n;
    const vec3 tangent_part = d - normal_part;
    return tangent_part - normal_part;
}
