// says, reordered: a grid of round(sqrt(n)) columns and ceil(n / columns) rows, of which some cells are left empty
vec2 stratified_2d(int i, int n, vec2 u) {
    const int c = int(std::round(std::sqrt(Real(n))));
    return {std::min((i % c + u.x) / c, below_one), std::min((i / c + u.y) / ((n + c - 1) / c), below_one)};
}
