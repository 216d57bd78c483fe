// says: a roulette of its own, which ends at u.y >= the mean albedo: the framework decides whether a path goes on
Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const Real mean = (albedo.x + albedo.y + albedo.z) / 3;
    if (u.y >= mean) return {n, Color(0)};
    return {frame_about(n).to_world(cosine_hemisphere(u).direction), albedo / mean};
}
