FilmSample film_sample(const Extent& pixel, int i, int n, vec2 u) {
    const vec2 cell = stratified_2d(i, n, u);
    const Real x = pixel.low.x + cell.x * (pixel.high.x - pixel.low.x);
    const Real y = pixel.low.y + cell.y * (pixel.high.y - pixel.low.y);
    return {{x, y}, 1};
}
