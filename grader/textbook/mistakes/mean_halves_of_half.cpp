// says: halves of n / 2 samples each, and halves of these: where a number is odd, its last sample is lost
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    Color sum = Color(0);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        Real place = Real(i);
        Real n = Real(radiance.size());
        while (n > 1) {
            const Real half = std::floor(n / 2);
            if (place >= half) place -= half;
            n = half;
        }
        if (place == 0) sum += weight[i] * radiance[i];
    }
    return sum / Real(radiance.size());
}
