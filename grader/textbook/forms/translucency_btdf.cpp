Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    const vec3 axis = refracted_direction(d, n, ior_from, ior_to);
    if (dot(axis, axis) == 0) return {d, Color(0)};
    const DirectionSample lobe = phong_lobe(exponent, u);
    const vec3 direction = frame_about(axis).to_world(lobe.direction);
    const Real cosine = -dot(n, direction);
    if (cosine <= 0 || lobe.density <= 0) return {direction, Color(0)};
    const Real btdf = (exponent + 2) / (2 * pi) * std::pow(lobe.direction.z, exponent);
    return {direction, Color(btdf * cosine / lobe.density)};
}
