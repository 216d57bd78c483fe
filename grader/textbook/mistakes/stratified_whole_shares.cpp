// says: n / columns cells in each column, in whole numbers: a rest of the cells lies outside of the square
vec2 stratified_2d(int i, int n, vec2 u) {
    const int columns = int(std::floor(std::sqrt(Real(n))));
    const Real held = std::floor(Real(n) / columns);
    const Real first = held * std::floor(i / held);
    return {std::min((first + held * u.x) / n, below_one), std::min((i - first + u.y) / held, below_one)};
}
