#include "calibration/peers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grade::calibration {

void PixelMoments::add(const rt::Image& image) {
    if (count == 0) mean = squares = rt::Image(image.width, image.height);
    ++count;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const rt::Color step = image.pixels[i] - mean.pixels[i];
        mean.pixels[i] += step / double(count);
        squares.pixels[i] += step * (image.pixels[i] - mean.pixels[i]);
    }
}

rt::Color PixelMoments::variance(std::size_t pixel) const {
    return count > 1 ? squares.pixels[pixel] / double(count - 1) : rt::Color(0);
}

PeerRules judged_by_peers(const rt::Image& picture, int pictures, const PixelMoments& reference) {
    const std::size_t pixels = picture.pixels.size(), values = 3 * pixels;
    const double alpha = 1 - std::pow(1 - 0.01, 1 / double(values));
    std::size_t passing = 0;
    double absolute = 0, own = 0, theirs = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const rt::Color off = picture.pixels[i] - reference.mean.pixels[i], variance = reference.variance(i);
        for (int c = 0; c < 3; ++c) {
            // a pixel without noise must agree to rounding
            const double error = std::sqrt(std::max(variance[c], 1e-12) / pictures);
            const double chance = std::erfc(std::abs(off[c]) / error / std::numbers::sqrt2);
            passing += chance > alpha;
            absolute += std::abs(off[c]);
            own += picture.pixels[i][c], theirs += reference.mean.pixels[i][c];
        }
    }
    return {double(passing) >= 0.9975 * double(values), absolute / double(values) < 0.1,
            std::abs(own - theirs) <= 0.025 * std::abs(theirs)};
}

}  // namespace grade::calibration
