vec2 stratified_2d(int i, int n, vec2 u) {
    const Real columns = std::floor(std::sqrt(Real(n)));
    const Real column = std::floor(i * columns / n);
    const Real first = std::ceil(column * n / columns);
    const Real count = std::ceil((column + 1) * n / columns) - first;
    const Real left = first / n;
    const Real width = count / n;
    const Real row = i - first;
    const Real bottom = row / count;
    const Real height = 1 / count;
    return {std::min(left + u.x * width, below_one), std::min(bottom + u.y * height, below_one)};
}
