// says: directions about the z axis, turned to the side of n but not into its frame
Scattered color_bleeding(vec3 n, Color albedo, vec2 u) {
    const vec3 direction = cosine_hemisphere(u).direction;
    return {dot(direction, n) < 0 ? -direction : direction, albedo};
}
