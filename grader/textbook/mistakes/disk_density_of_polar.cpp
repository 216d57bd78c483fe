// says: the density over radius and angle, r / pi; expected that per area, 1 / pi
DiskSample uniform_disk(vec2 u) {
    const vec2 p = uniform_disk(u).point;
    return {p, std::sqrt(p.x * p.x + p.y * p.y) / pi};
}
