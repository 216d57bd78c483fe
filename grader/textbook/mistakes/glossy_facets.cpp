// says: a lobe of normals about n, at each of which the ray is mirrored; expected a lobe about the mirror direction
Scattered glossy_reflection(vec3 d, vec3 n, Real exponent, vec2 u) {
    const vec3 facet = frame_about(n).to_world(phong_lobe(exponent, u).direction);
    const vec3 direction = mirror_direction(d, facet);
    return {direction, Color((exponent + 2) / (exponent + 1) * std::max(dot(direction, n), 0.0))};
}
