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

}  // namespace grade
