// says, reordered: a grid of floor(sqrt(n)) columns and floor(n / columns) rows: the last cells of some n lie outside
vec2 stratified_2d(int i, int n, vec2 u) {
    const int columns = int(std::floor(std::sqrt(Real(n))));
    const int rows = n / columns;
    return {(i % columns + u.x) / columns, (i / columns + u.y) / rows};
}
