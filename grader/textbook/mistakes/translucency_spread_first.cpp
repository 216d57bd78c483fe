// says: a lobe about d, each of whose directions is refracted; expected a lobe about the refracted direction
Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    const vec3 spread = frame_about(d).to_world(phong_lobe(exponent, u).direction);
    if (dot(spread, n) >= 0) return {d, Color(0)};
    const vec3 inside = refracted_direction(spread, n, ior_from, ior_to);
    if (inside == vec3(0)) return {d, Color(0)};
    return {inside, Color(-dot(inside, n) * (exponent + 2) / (exponent + 1))};
}
