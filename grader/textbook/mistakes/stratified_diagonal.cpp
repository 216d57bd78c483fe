// says: x and y both in the strip of cell i: cells along the diagonal alone
vec2 stratified_2d(int i, int n, vec2 u) {
    return {std::min((i + u.x) / n, below_one), std::min((i + u.y) / n, below_one)};
}
