#include "statistics/noise.h"

#include <cmath>

#include "statistics/moments.h"

namespace grade {

namespace {

/// Calls f with the moments, over the images, of each pixel's brightness.
template <class F>
void over_pixels(std::span<const rt::Image> images, const Region& region, F&& f) {
    for (int y = region.y; y < region.y + region.height; ++y)
        for (int x = region.x; x < region.x + region.width; ++x) {
            Moments pixel;
            for (const rt::Image& image : images) pixel.add(brightness(image.at(x, y)));
            f(pixel);
        }
}

double mean_variance(std::span<const rt::Image> images, const Region& region) {
    Moments variances;
    over_pixels(images, region, [&](const Moments& pixel) { variances.add(pixel.variance()); });
    return variances.mean;
}

}  // namespace

double design_effect(std::span<const rt::Image> images, const Region& region) {
    Moments means;
    for (const rt::Image& image : images) means.add(brightness(region_mean(image, region)));
    return region.width * region.height * means.variance() / mean_variance(images, region);
}

double dispersion(std::span<const rt::Image> images, const Region& region, int samples) {
    Moments ratios;
    const double n = double(images.size());
    over_pixels(images, region, [&](const Moments& pixel) {
        const double p = pixel.mean;
        // p (1 - p) of an estimated p is too small by the variance of p
        const double spread = p * (1 - p) + pixel.variance() / n;
        if (p > 0 && p < 1) ratios.add(samples * pixel.variance() / spread);
    });
    return ratios.count > 0 ? ratios.mean : NAN;
}

double noise_level(std::span<const rt::Image> images, const Region& region) {
    return std::sqrt(mean_variance(images, region));
}

}  // namespace grade
