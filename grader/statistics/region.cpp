#include "statistics/region.h"

namespace grade {

rt::Color region_mean(const rt::Image& image, const Region& region) {
    rt::Color sum(0);
    for (int y = region.y; y < region.y + region.height; ++y)
        for (int x = region.x; x < region.x + region.width; ++x) sum += image.at(x, y);
    return sum / double(region.width * region.height);
}

std::vector<double> column_profile(const rt::Image& image, const Region& region) {
    std::vector<double> profile;
    for (int x = 0; x < region.width; ++x)
        profile.push_back(brightness(region_mean(image, {region.x + x, region.y, 1, region.height})));
    return profile;
}

}  // namespace grade
