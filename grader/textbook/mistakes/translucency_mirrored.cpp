// says: a ray on the wrong side mirrored at the surface and counted; expected weight 0
Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    const vec3 axis = refracted_direction(d, n, ior_from, ior_to);
    if (axis == vec3(0)) return {d, Color(0)};
    const DirectionSample lobe = phong_lobe(exponent, u);
    const vec3 sampled = frame_about(axis).to_world(lobe.direction);
    const vec3 direction = sampled - 2 * std::max(dot(sampled, n), 0.0) * n;
    return {direction, Color((exponent + 2) / (exponent + 1) * -dot(direction, n))};
}
