#pragma once

#include "rt/files/image.h"

namespace grade::calibration {

/// Mean and variance of each pixel over independent pictures.
struct PixelMoments {
    rt::Image mean, squares;  // squares: sums of squared deviations
    int count = 0;

    void add(const rt::Image& image);
    /// Unbiased, of one picture.
    rt::Color variance(std::size_t pixel) const;
};

/// Whether a picture passes the simple rules by which others judge one, against the mean of the reference's pictures.
struct PeerRules {
    bool z_test = true;           // of each pixel and channel: 99.75 % must pass at 1 %, corrected for their number
    bool mean_difference = true;  // mean absolute difference of all pixels below 0.1
    bool global_mean = true;      // mean of the picture within 2.5 %
};

/// picture    mean of `pictures` pictures of the submission
///
/// Source: the rules of Mitsuba 3's test_renders (two-sided z-test of each pixel with Sidak's correction), of
/// lightwave's image tests, and of pbrt-v4's furnace tests, written anew.
PeerRules judged_by_peers(const rt::Image& picture, int pictures, const PixelMoments& reference);

}  // namespace grade::calibration
