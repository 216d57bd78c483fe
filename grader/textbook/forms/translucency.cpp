Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    const vec3 axis = refracted_direction(d, n, ior_from, ior_to);
    if (axis == vec3(0)) return {d, Color(0)};
    const DirectionSample lobe = phong_lobe(exponent, u);
    const vec3 direction = frame_about(axis).to_world(lobe.direction);
    const Real cosine = -dot(direction, n);
    const Real weight = cosine > 0 ? (exponent + 2) / (exponent + 1) * cosine : 0.0;
    return {direction, Color(weight)};
}
