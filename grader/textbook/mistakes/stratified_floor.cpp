// says, reordered: cells i % c and i / c with c = floor(sqrt(n)), which fill the square for a square n alone
vec2 stratified_2d(int i, int n, vec2 u) {
    const int c = int(std::floor(std::sqrt(Real(n))));
    return {(i % c + u.x) / c, (i / c + u.y) / c};
}
