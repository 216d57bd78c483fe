#include "statistics/spread.h"

#include <algorithm>
#include <vector>

namespace grade {

Spread edge_spread(std::span<const double> profile) {
    std::vector<double> step;
    for (std::size_t k = 1; k < profile.size(); ++k) step.push_back(profile[k] - profile[k - 1]);
    Spread s;
    for (std::size_t k = 0; k < step.size(); ++k) {
        s.mass += step[k];
        s.mean += step[k] * (double(k) + 0.5);
    }
    s.mean /= s.mass;
    for (std::size_t k = 0; k < step.size(); ++k) s.variance += step[k] * rt::sqr(double(k) + 0.5 - s.mean) / s.mass;
    s.mean += 0.5;  // the first difference lies between pixels 0 and 1
    return s;
}

SlantedSpread slanted_spread(const rt::Image& image, const Region& region, const Edge& edge, double left,
                             double right) {
    SlantedSpread s{0, 1.0 / 12};
    for (int y = region.y; y < region.y + region.height; ++y)
        for (int x = region.x; x < region.x + region.width; ++x) {
            const double d = x + 0.5 - (edge.offset + edge.slope * (y + 0.5));
            const double level = (brightness(image.at(x, y)) - left) / (right - left);
            const double missing = std::clamp(d + 0.5, 0.0, 1.0) - level;
            s.mean += missing / region.height;
            s.mean_square += 2 * d * missing / region.height;
        }
    return s;
}

rt::Image transposed(const rt::Image& image) {
    rt::Image result(image.height, image.width);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) result.at(y, x) = image.at(x, y);
    return result;
}

}  // namespace grade
