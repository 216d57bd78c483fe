// says: cells i / c and i % c with c = floor(sqrt(n)), which fill the square for a square n alone
vec2 stratified_2d(int i, int n, vec2 u) {
    const int c = int(std::floor(std::sqrt(Real(n))));
    return {std::min((i / c + u.x) / c, below_one), std::min((i % c + u.y) / c, below_one)};
}
