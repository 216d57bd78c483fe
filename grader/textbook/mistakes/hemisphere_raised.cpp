// says: the disk laid in the plane z = 1, at most 45 degrees from z; expected z = sqrt(1 - x^2 - y^2)
DirectionSample cosine_hemisphere(vec2 u) {
    const vec2 p = uniform_disk(u).point;
    const vec3 direction = unit(vec3(p.x, p.y, 1));
    return {direction, direction.z / pi};
}
