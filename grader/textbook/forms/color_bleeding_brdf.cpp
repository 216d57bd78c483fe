Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const DirectionSample sample = cosine_hemisphere(u);
    const vec3 direction = frame_about(n).to_world(sample.direction);
    const Color brdf = albedo / pi;
    const Real cosine = dot(n, direction);
    return {direction, brdf * cosine / sample.density};
}
