FilmSample film_sample(const Extent& pixel, int i, int n, vec2 u) {
    const vec2 size = pixel.high - pixel.low;
    return {pixel.low + stratified_2d(i, n, u) * size, 1};
}
