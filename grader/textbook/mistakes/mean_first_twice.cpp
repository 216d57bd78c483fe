// says: a sum that starts at radiance[0], which is added again
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    Color sum = radiance[0];
    for (std::size_t i = 0; i < radiance.size(); ++i) sum += weight[i] * radiance[i];
    return sum / Real(radiance.size());
}
