// says: 1 - r as the z above a disk's point, made a unit vector: another spread; expected sqrt(1 - r * r) as z
DirectionSample cosine_hemisphere(vec2 u) {
    const vec2 p = uniform_disk(u).point;
    const vec3 direction = unit(vec3(p.x, p.y, 1 - std::sqrt(p.x * p.x + p.y * p.y)));
    return {direction, direction.z / pi};
}
