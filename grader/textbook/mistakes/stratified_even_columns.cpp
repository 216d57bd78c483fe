// says: columns of one width, though they hold different numbers of cells
vec2 stratified_2d(int i, int n, vec2 u) {
    const Real columns = std::floor(std::sqrt(Real(n)));
    const Real column = std::floor(i * columns / n);
    const Real first = std::ceil(column * n / columns);
    const Real next = std::ceil((column + 1) * n / columns);
    return {std::min((column + u.x) / columns, below_one), std::min((i - first + u.y) / (next - first), below_one)};
}
