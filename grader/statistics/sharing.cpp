#include "statistics/sharing.h"

#include <array>
#include <utility>

#include "statistics/moments.h"

namespace grade {

namespace {

constexpr double tiny = 1e-12;

/// Moments of a region's pixels, channel by channel.
std::array<Moments, 3> channels(const rt::Image& image, const Region& region) {
    std::array<Moments, 3> all;
    for (int y = region.y; y < region.y + region.height; ++y)
        for (int x = region.x; x < region.x + region.width; ++x)
            for (int c = 0; c < 3; ++c) all[std::size_t(c)].add(image.at(x, y)[c]);
    return all;
}

/// Variance within the image, and the one that independent samples have.
std::pair<double, double> variances(const std::array<Moments, 3>& channels, int samples) {
    double within = 0, independent = 0;
    for (const Moments& channel : channels) {
        within += channel.variance();
        independent += channel.mean * (1 - channel.mean) / samples;
    }
    return {within, independent};
}

/// Intraclass correlation of groups of pixels; group(k, i) is the place of pixel i of group k.
template <class Place>
double correlation(const rt::Image& image, int groups, int each, Place place) {
    double between = 0, within = 0;
    for (int c = 0; c < 3; ++c) {
        Moments means;
        for (int k = 0; k < groups; ++k) {
            Moments group;
            for (int i = 0; i < each; ++i) {
                const auto [x, y] = place(k, i);
                group.add(image.at(x, y)[c]);
            }
            means.add(group.mean);
            within += group.m2 / (groups * (each - 1.0));
        }
        between += each * means.variance();
    }
    return between + within > tiny ? (between - within) / (between + (each - 1) * within) : 1;
}

}  // namespace

Sharing sharing(const rt::Image& image, const Region& region, int samples) {
    const auto all = channels(image, region);
    const auto [within, independent] = variances(all, samples);
    if (all[0].mean + all[1].mean + all[2].mean < tiny) return {};
    Sharing s;
    s.all = independent > tiny ? 1 - within / independent : 1;
    s.rows = correlation(image, region.height, region.width,
                         [&](int k, int i) { return std::pair(region.x + i, region.y + k); });
    s.columns = correlation(image, region.width, region.height,
                            [&](int k, int i) { return std::pair(region.x + k, region.y + i); });
    return s;
}

double within_variance(const rt::Image& image, const Region& region, int samples) {
    const auto [within, independent] = variances(channels(image, region), samples);
    return independent > tiny ? within / independent : 0;
}

}  // namespace grade
