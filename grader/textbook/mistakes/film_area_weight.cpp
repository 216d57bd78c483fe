// says: the area of a cell, 1 / n, as the weight; the mean divides by n, so all samples count with weight 1
FilmSample film_sample(const Extent& pixel, int i, int n, vec2 u) {
    return {pixel.low + stratified_2d(i, n, u) * (pixel.high - pixel.low), 1.0 / n};
}
