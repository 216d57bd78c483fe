#include <algorithm>

#include "rt/show/encode.h"

namespace rt {

Shown shown(const Image& image, Real exposure, int width, int height) {
    const Real scale = std::min({Real(1), Real(width) / image.width, Real(height) / image.height});
    Shown s{std::max(1, int(scale * image.width)), std::max(1, int(scale * image.height)), {}};
    s.rgb.reserve(3 * std::size_t(s.width) * std::size_t(s.height));
    // Pixel i of n stands for those from the i-th n-th of the picture to the next.
    const auto cut = [](int i, int n, int all) { return int(std::int64_t(i) * all / n); };
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) {
            Color sum{0};
            const int left = cut(x, s.width, image.width), right = cut(x + 1, s.width, image.width),
                      top = cut(y, s.height, image.height), bottom = cut(y + 1, s.height, image.height);
            for (int j = top; j < bottom; ++j)
                for (int i = left; i < right; ++i) sum += image.at(i, j);
            const Color mean = sum / Real((right - left) * (bottom - top));
            for (int i = 0; i < 3; ++i) s.rgb.push_back(to_srgb(exposure * mean[i]));
        }
    return s;
}

}  // namespace rt
