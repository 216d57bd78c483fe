// says: the disk laid in the plane z = 1, so that no direction is further than 45 degrees from z; expected its points raised to the hemisphere, z = sqrt(1 - x^2 - y^2)
DirectionSample cosine_hemisphere(vec2 u) {
    const vec2 p = uniform_disk(u).point;
    const vec3 direction = unit(vec3(p.x, p.y, 1));
    return {direction, direction.z / pi};
}
