// says: a lobe of normals about n, at each of which the ray is refracted; expected a lobe about the refracted direction
Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    const vec3 facet = frame_about(n).to_world(phong_lobe(exponent, u).direction);
    const vec3 direction = refracted_direction(d, facet, ior_from, ior_to);
    if (direction == vec3(0)) return {d, Color(0)};
    return {direction, Color((exponent + 2) / (exponent + 1) * std::max(-dot(direction, n), 0.0))};
}
