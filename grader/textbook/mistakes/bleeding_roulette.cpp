// says: a roulette of its own, which ends at u.x >= the largest albedo: the framework decides whether a path goes on
Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const Real most = std::max(albedo.x, std::max(albedo.y, albedo.z));
    if (u.x >= most) return {n, Color(0)};
    return {frame_about(n).to_world(cosine_hemisphere(u).direction), albedo / most};
}
