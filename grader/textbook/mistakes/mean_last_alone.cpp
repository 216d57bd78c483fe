// says: the last sample alone; expected the sum of all, divided by n
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    const std::size_t last = radiance.size() - 1;
    return weight[last] * radiance[last] / Real(radiance.size());
}
