// says, reordered: cells i % c and i / c with c = ceil(sqrt(n)), which leave cells empty where n is no square
vec2 stratified_2d(int i, int n, vec2 u) {
    const int c = int(std::ceil(std::sqrt(Real(n))));
    return {(i % c + u.x) / c, (i / c + u.y) / c};
}
