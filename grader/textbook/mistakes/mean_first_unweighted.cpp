// says: a sum that starts at radiance[0] without its weight
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    Color sum = radiance[0];
    for (std::size_t i = 1; i < radiance.size(); ++i) sum += weight[i] * radiance[i];
    return sum / Real(radiance.size());
}
