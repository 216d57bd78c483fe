vec2 stratified_2d(int i, int n, vec2 u) {
    const Real columns = std::floor(std::sqrt(Real(n)));
    const Real column = std::floor(i * columns / n);
    const Real first = std::ceil(column * n / columns);
    const Real next = std::ceil((column + 1) * n / columns);
    const Real x = (first + u.x * (next - first)) / n;
    const Real y = (i - first + u.y) / (next - first);
    return {std::min(x, below_one), std::min(y, below_one)};
}
