// says: rays into the surface counted, with |cos|, in place of weight 0
Scattered glossy_reflection(vec3 d, vec3 n, Real exponent, vec2 u) {
    const vec3 axis = mirror_direction(d, n);
    const vec3 direction = frame_about(axis).to_world(phong_lobe(exponent, u).direction);
    return {direction, Color((exponent + 2) / (exponent + 1) * std::abs(dot(direction, n)))};
}
