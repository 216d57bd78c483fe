// says: the mean of the radiance times the mean of the weights; expected the mean of the products
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    Color sum = Color(0);
    Real weights = 0;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        sum += radiance[i];
        weights += weight[i];
    }
    return sum * weights / (Real(radiance.size()) * Real(radiance.size()));
}
