// says: the square 2 * u - 1, whose corners lie outside of the disk
DiskSample uniform_disk(vec2 u) { return {2.0 * u - vec2(1), 1 / pi}; }
