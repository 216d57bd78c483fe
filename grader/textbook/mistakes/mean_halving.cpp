// says: (mean + next) / 2 at each step: the last sample counts as much as all before it; expected all alike
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    Color mean = weight[0] * radiance[0];
    for (std::size_t i = 1; i < radiance.size(); ++i) mean = (mean + weight[i] * radiance[i]) / 2.0;
    return mean;
}
