// says: the sum of the weights in place of the number of samples
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    Color sum = Color(0);
    Real weights = 0;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        sum += weight[i] * radiance[i];
        weights += weight[i];
    }
    return sum / weights;
}
