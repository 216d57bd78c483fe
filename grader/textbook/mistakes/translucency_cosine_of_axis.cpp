// says: the cosine to the refracted direction in the weight; expected that to the normal, -dot(direction, n)
Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    const vec3 axis = refracted_direction(d, n, ior_from, ior_to);
    if (axis == vec3(0)) return {d, Color(0)};
    const vec3 local = phong_lobe(exponent, u).direction;
    const vec3 direction = frame_about(axis).to_world(local);
    if (dot(direction, n) >= 0) return {direction, Color(0)};
    return {direction, Color((exponent + 2) / (exponent + 1) * local.z)};
}
