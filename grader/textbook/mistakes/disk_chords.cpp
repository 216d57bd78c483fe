// says: x uniform, and y uniform on the chord there: short chords get as many points as long ones
DiskSample uniform_disk(vec2 u) {
    const Real x = 2 * u.x - 1;
    const Real half = safe_sqrt(1 - x * x);
    return {{x, (2 * u.y - 1) * half}, 1 / pi};
}
