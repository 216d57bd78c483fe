Scattered glossy_reflection(vec3 d, vec3 n, Real exponent, vec2 u) {
    const vec3 axis = d - 2 * dot(d, n) * n;
    const DirectionSample lobe = phong_lobe(exponent, u);
    const vec3 direction = frame_about(axis).to_world(lobe.direction);
    const Real cosine = dot(n, direction);
    if (cosine <= 0 || lobe.density <= 0) return {direction, Color(0)};
    const Real brdf = (exponent + 2) / (2 * pi) * std::pow(lobe.direction.z, exponent);
    return {direction, Color(brdf * cosine / lobe.density)};
}
