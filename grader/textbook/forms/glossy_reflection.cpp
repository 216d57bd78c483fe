Scattered glossy_reflection(vec3 d, vec3 n, Real exponent, vec2 u) {
    const vec3 axis = mirror_direction(d, n);
    const DirectionSample lobe = phong_lobe(exponent, u);
    const vec3 direction = frame_about(axis).to_world(lobe.direction);
    const Real cosine = dot(direction, n);
    const Real weight = cosine > 0 ? (exponent + 2) / (exponent + 1) * cosine : 0.0;
    return {direction, Color(weight)};
}
