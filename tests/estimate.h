#pragma once

#include <vector>

#include "rt/render.h"

/// What pictures of a scene have in the mean, and how noisy they are.
namespace rt {

struct Estimate {
    Color mean{0}, variance{0};  // of the picture's mean
    Real noise = 0;              // mean variance of a pixel
};

/// From so many pictures of different seeds.
inline Estimate estimate(const Scene& scene, Sampler sampler, int pictures) {
    Estimate e;
    std::vector<Image> all;
    for (int k = 0; k < pictures; ++k)
        all.push_back(render(scene, {.samples = scene.samples,
                                     .seed = std::uint64_t(k),
                                     .sampler = sampler,
                                     .one_of_many = true,
                                     .estimate_error = false})
                          .image);
    std::vector<Color> means;
    for (const Image& image : all) {
        Color mean{0};
        for (const Color c : image.pixels) mean += c / Real(image.pixels.size());
        means.push_back(mean);
        e.mean += mean / Real(pictures);
    }
    for (const Color m : means) e.variance += (m - e.mean) * (m - e.mean) / Real(pictures * (pictures - 1));
    for (std::size_t p = 0; p < all[0].pixels.size(); ++p) {
        Color mean{0};
        for (const Image& image : all) mean += image.pixels[p] / Real(pictures);
        for (const Image& image : all) {
            const Color d = image.pixels[p] - mean;
            e.noise += dot(d, d) / Real(3 * (pictures - 1)) / Real(all[0].pixels.size());
        }
    }
    return e;
}

}  // namespace rt
