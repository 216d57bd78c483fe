Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const DirectionSample sample = cosine_hemisphere(u);
    const vec3 direction = frame_about(n).to_world(sample.direction);
    return {direction, albedo};
}
