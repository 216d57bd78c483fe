// says: rays that stay on this side counted, with |cos|, in place of weight 0
Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    const vec3 axis = refracted_direction(d, n, ior_from, ior_to);
    if (axis == vec3(0)) return {d, Color(0)};
    const vec3 direction = frame_about(axis).to_world(phong_lobe(exponent, u).direction);
    return {direction, Color((exponent + 2) / (exponent + 1) * std::abs(dot(direction, n)))};
}
