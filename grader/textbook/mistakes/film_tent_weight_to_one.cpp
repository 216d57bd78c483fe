// says: a tent as the weight, 1 in the middle of the pixel and 0 at its edge; all samples count alike, with weight 1
FilmSample film_sample(const Extent& pixel, int i, int n, vec2 u) {
    const vec2 cell = stratified_2d(i, n, u);
    const Real x = 1 - 2 * std::abs(cell.x - 0.5);
    const Real y = 1 - 2 * std::abs(cell.y - 0.5);
    return {pixel.low + cell * (pixel.high - pixel.low), x * y};
}
