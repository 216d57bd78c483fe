// says: pairs, and pairs of these: where a level has an odd number of sums, its last one is lost
Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    Color sum = Color(0);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        Real place = Real(i);
        Real kept = 1;
        Real n = Real(radiance.size());
        while (n > 1) {
            const Real half = std::floor(n / 2);
            if (n > 2 * half && place == n - 1) kept = 0;
            place = std::floor(place / 2);
            n = half;
        }
        sum += kept * weight[i] * radiance[i];
    }
    return sum / Real(radiance.size());
}
