// says: at total internal reflection the mirrored lobe in place of weight 0
Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    const vec3 axis = refracted_direction(d, n, ior_from, ior_to);
    if (axis == vec3(0)) return glossy_reflection(d, n, exponent, u);
    const DirectionSample lobe = phong_lobe(exponent, u);
    const vec3 direction = frame_about(axis).to_world(lobe.direction);
    const Real cosine = -dot(direction, n);
    return {direction, Color(cosine > 0 ? (exponent + 2) / (exponent + 1) * cosine : 0.0)};
}
