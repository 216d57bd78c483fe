#include "statistics/blob.h"

namespace grade {

Blob blob_moments(const rt::Image& image, const Region& region) {
    const auto over_pixels = [&](auto&& f) {
        for (int y = region.y; y < region.y + region.height; ++y)
            for (int x = region.x; x < region.x + region.width; ++x)
                f(rt::vec2(x + 0.5, y + 0.5), brightness(image.at(x, y)));
    };

    Blob b;
    over_pixels([&](rt::vec2 p, double light) {
        b.mass += light;
        b.centroid += light * p;
    });
    b.centroid /= b.mass;

    double radial_fourth = 0;
    over_pixels([&](rt::vec2 p, double light) {
        const double share = light / b.mass;
        const rt::vec2 d = p - b.centroid, square = d * d;
        b.variance += share * square;
        b.covariance += share * d.x * d.y;
        radial_fourth += share * rt::sqr(square.x + square.y);
    });
    b.radial_square = b.variance.x + b.variance.y;
    b.radial_kurtosis = radial_fourth / rt::sqr(b.radial_square);
    return b;
}

ColorMoments color_moments(const rt::Image& image, const Region& region, rt::vec2 center, double radius) {
    double mass[2] = {0, 0}, square[2] = {0, 0};
    rt::vec2 first[2] = {rt::vec2(0), rt::vec2(0)};
    for (int y = region.y; y < region.y + region.height; ++y)
        for (int x = region.x; x < region.x + region.width; ++x) {
            const rt::vec2 p = (rt::vec2(x + 0.5, y + 0.5) - center) / radius;
            for (int c = 0; c < 2; ++c) {
                const double light = image.at(x, y)[c];
                mass[c] += light;
                first[c] += light * p;
                square[c] += light * rt::dot(p, p);
            }
        }
    return {first[0] / mass[0] - first[1] / mass[1], square[0] / mass[0] - square[1] / mass[1]};
}

}  // namespace grade
