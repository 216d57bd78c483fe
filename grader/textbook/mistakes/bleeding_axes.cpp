// says: local.z * n + local.x * y + local.y * z: the axes of the frame in another order
Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const vec3 local = cosine_hemisphere(u).direction;
    return {frame_about(n).to_world({local.z, local.x, local.y}), albedo};
}
