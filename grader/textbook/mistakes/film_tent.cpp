// says: the tent filter's points, which crowd in the middle of the pixel; expected points all over it alike
FilmSample film_sample(const Extent& pixel, int i, int n, vec2 u) {
    const vec2 cell = 2.0 * stratified_2d(i, n, u);
    const Real dx = cell.x < 1 ? std::sqrt(cell.x) - 1 : 1 - std::sqrt(2 - cell.x);
    const Real dy = cell.y < 1 ? std::sqrt(cell.y) - 1 : 1 - std::sqrt(2 - cell.y);
    const vec2 middle = 0.5 * (pixel.low + pixel.high);
    return {middle + 0.5 * vec2(dx, dy) * (pixel.high - pixel.low), 1};
}
