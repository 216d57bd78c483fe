Color pixel_mean(std::span<const Color> radiance, std::span<const Real> weight) {
    Real red = 0;
    Real green = 0;
    Real blue = 0;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        red += weight[i] * radiance[i].x;
        green += weight[i] * radiance[i].y;
        blue += weight[i] * radiance[i].z;
    }
    const Real n = Real(radiance.size());
    return Color(red / n, green / n, blue / n);
}
