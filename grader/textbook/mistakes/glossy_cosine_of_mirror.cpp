// says: the cosine to the mirror direction in the weight; expected that to the normal, dot(direction, n)
Scattered glossy_reflection(vec3 d, vec3 n, Real exponent, vec2 u) {
    const vec3 local = phong_lobe(exponent, u).direction;
    const vec3 direction = frame_about(mirror_direction(d, n)).to_world(local);
    if (dot(direction, n) <= 0) return {direction, Color(0)};
    return {direction, Color((exponent + 2) / (exponent + 1) * local.z)};
}
