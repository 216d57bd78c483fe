#pragma once

#include <optional>
#include <string>

#include "rt/files/image.h"
#include "statistics/verdict.h"

namespace grade {

struct ImageFault {
    Verdict verdict;    // not_finite, or failed
    std::string words;  // with the first such pixel
    Trouble trouble = Trouble::no_radiance;
};

/// What makes data no picture of radiance, before any statistic: wrong size, a number that is not finite, a negative
/// one. None: nothing of that kind.
std::optional<ImageFault> image_fault(const rt::Image& image, int width, int height);

/// Whether the values are those of an 8-bit picture, linear or sRGB: at least 16 different ones, all on its levels.
bool is_quantised(const rt::Image& image);

/// Whether two images agree bit by bit: of two seeds they must not, of one seed they must.
bool is_same(const rt::Image& a, const rt::Image& b);

}  // namespace grade
