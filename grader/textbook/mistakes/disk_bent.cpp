// says: x * sqrt(1 - y^2 / 2) and y * sqrt(1 - x^2 / 2): the square bent into a disk, which is not uniform in area
DiskSample uniform_disk(vec2 u) {
    const vec2 q = 2.0 * u - 1.0;
    return {{q.x * std::sqrt(1 - q.y * q.y / 2), q.y * std::sqrt(1 - q.x * q.x / 2)}, 1 / pi};
}
