// says: a ray on the wrong side mirrored at the surface and counted; expected weight 0
Scattered glossy_reflection(vec3 d, vec3 n, Real exponent, vec2 u) {
    const DirectionSample lobe = phong_lobe(exponent, u);
    const vec3 sampled = frame_about(mirror_direction(d, n)).to_world(lobe.direction);
    const Real below = std::min(dot(sampled, n), 0.0);
    const vec3 direction = sampled - 2 * below * n;
    return {direction, Color((exponent + 2) / (exponent + 1) * dot(direction, n))};
}
