// says: a running mean that divides each step by n: earlier samples count less; expected by the number so far, i + 1
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    Color mean = Color(0);
    for (std::size_t i = 0; i < radiance.size(); ++i) mean += (weight[i] * radiance[i] - mean) / Real(radiance.size());
    return mean;
}
