// says: the square 2 * u - 1, of which what lies outside of the disk is put onto its border
DiskSample uniform_disk(vec2 u) {
    const vec2 square = 2.0 * u - vec2(1);
    return {square / std::max(1.0, glm::length(square)), 1 / pi};
}
