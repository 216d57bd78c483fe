#pragma once

#include "rt/files/image.h"
#include "statistics/region.h"

namespace grade {

/// Moments of a spot of light on black, per axis and about its centre, in pixels. Where pixels average over their area
/// they add 1/12 to the variance.
struct Blob {
    double mass = 0;       // sum of brightness
    rt::vec2 centroid{0};  // from the image's top left corner
    rt::vec2 variance{0};
    double covariance = 0;
    double radial_square = 0;    // mean square of the distance from the centroid
    double radial_kurtosis = 0;  // mean fourth power over the square of that: uniform disc 4/3
};

Blob blob_moments(const rt::Image& image, const Region& region);
inline Blob blob_of(const rt::Image& image) { return blob_moments(image, whole(image)); }

/// How the red and the green light of a spot differ in place, in units of a radius: red less green. All are 0 where
/// what makes the colour and what makes the place do not go together.
struct ColorMoments {
    rt::vec2 centroid{0};  // over the radius
    double square = 0;     // mean square of the distance from the spot's centre, over the radius^2
};

/// center  of the spot, from the image's top left corner [pixel]
ColorMoments color_moments(const rt::Image& image, const Region& region, rt::vec2 center, double radius);

}  // namespace grade
