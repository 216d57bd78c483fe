// says: 1 - r as the z above a disk's point, a cone and no sphere; expected sqrt(1 - r * r)
DirectionSample cosine_hemisphere(vec2 u) {
    const vec2 p = uniform_disk(u).point;
    const Real z = 1 - std::sqrt(p.x * p.x + p.y * p.y);
    return {{p.x, p.y, z}, z / pi};
}
