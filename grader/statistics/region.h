#pragma once

#include <vector>

#include "rt/files/image.h"

namespace grade {

/// A rectangle of pixels: x, y of its top left corner.
struct Region {
    int x = 0, y = 0, width = 0, height = 0;
};

inline Region whole(const rt::Image& image) { return {0, 0, image.width, image.height}; }

/// Mean of the three channels.
inline double brightness(rt::Color c) { return (c.x + c.y + c.z) / 3; }

rt::Color region_mean(const rt::Image& image, const Region& region);

/// Brightness of each column, averaged over its rows: a profile from left to right.
std::vector<double> column_profile(const rt::Image& image, const Region& region);

}  // namespace grade
