#include "statistics/colors.h"

namespace grade {

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
