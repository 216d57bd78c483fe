// says: n plus a direction about the z axis, not that direction turned into the frame of n
Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const vec3 local = cosine_hemisphere(u).direction;
    return {unit(n + local), albedo};
}
