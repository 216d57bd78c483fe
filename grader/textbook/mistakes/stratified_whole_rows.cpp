// says: columns of n / c cells each, of whole numbers
vec2 stratified_2d(int i, int n, vec2 u) {
    const Real c = std::floor(std::sqrt(Real(n)));
    const Real rows = std::floor(n / c);
    const Real column = std::floor(i / rows);
    return {std::min((column + u.x) / c, below_one), std::min((i - column * rows + u.y) / rows, below_one)};
}
