// says: the first cell of a column rounded down: floor(column * n / columns) in place of ceil(column * n / columns)
vec2 stratified_2d(int i, int n, vec2 u) {
    const Real columns = std::floor(std::sqrt(Real(n)));
    const Real column = std::floor(i * columns / n);
    const Real first = std::floor(column * n / columns);
    const Real next = std::floor((column + 1) * n / columns);
    const Real x = (first + u.x * (next - first)) / n;
    const Real y = (i - first + u.y) / (next - first);
    return {std::min(x, below_one), std::min(y, below_one)};
}
