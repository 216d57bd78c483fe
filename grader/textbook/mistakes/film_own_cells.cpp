// says: cells of its own with c = floor(sqrt(n)), which fill the pixel for a square n alone
FilmSample film_sample(const Extent& pixel, int i, int n, vec2 u) {
    const int c = int(std::floor(std::sqrt(Real(n))));
    const vec2 cell = vec2((i % c + u.x) / c, (i / c + u.y) / c);
    return {pixel.low + cell * (pixel.high - pixel.low), 1};
}
