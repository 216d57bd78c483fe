#pragma once

#include "checks/kit/estimate.h"
#include "checks/kit/later.h"
#include "checks/kit/scene.h"
#include "rt/ray.h"
#include "statistics/blob.h"
#include "statistics/region.h"

/// Checks that render, and numbers of their pictures.
namespace grade {

Check render_check(std::string name, Render render, std::vector<Statistic> statistics);

using PictureNumber = std::function<double(const rt::Image&)>;

/// A number of the picture; a tenth of delta is right in any case, unless it is said otherwise.
struct Picture {
    std::string id, what;
    PictureNumber number;
    double truth = 1, delta = 0;
    std::optional<double> delta0{};
    bool exact = false;
    Hint hint;
    Cause cause{};
};
Statistic of_picture(const Picture& picture);

/// Rays of one kind for each ray of the camera: what costs time, and what it is to save.
Statistic rays_of_kind(std::string id, rt::RayKind kind, double truth, double delta, Hint hint);

/// One statistic for each channel.
std::vector<Statistic> rgb(const std::function<Statistic(int channel, const std::string& name)>& of_channel);

/// The light of some pixels over what must be.
///
/// chosen(x, y)  whether a pixel is one of them
/// light(color)  what a pixel adds
/// due(x, y)     what it must add
template <class Chosen, class Light, class Due>
PictureNumber light_over_due(rt::ivec2 size, Chosen chosen, Light light, Due due) {
    const auto pixels = later([=] {
        std::vector<rt::ivec2> all;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (chosen(x, y)) all.emplace_back(x, y);
        return all;
    });
    const auto all_due = later([=] {
        double sum = 0;
        for (const rt::ivec2 p : pixels()) sum += due(p.x, p.y);
        return sum;
    });
    return [=](const rt::Image& image) {
        double seen = 0;
        for (const rt::ivec2 p : pixels()) seen += light(image.at(p.x, p.y));
        return seen / all_due();
    };
}

/// The picture whose pixel x, y is grey(x, y).
template <class Grey>
rt::Image picture_of(rt::ivec2 size, Grey grey) {
    rt::Image image(size.x, size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) image.at(x, y) = rt::Color(grey(x, y));
    return image;
}

/// The moments of a picture, of which light(film) is known in the middle of each pixel.
template <class Light>
Blob moments_of_middles(const rt::Camera& camera, Light light) {
    const rt::Image image = picture_of(camera.size, [&](int x, int y) { return light(rt::vec2(x + 0.5, y + 0.5)); });
    Blob blob = blob_of(image);
    blob.radial_square += 1.0 / 6;  // a pixel is the mean over its area, not its middle's value
    return blob;
}

/// The mean of a function of the film over pixel x, y, from n x n points.
template <class F>
double over_pixel(int x, int y, F f, int n = 4) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += f(rt::vec2(x + (i + 0.5) / n, y + (j + 0.5) / n));
    return sum / (n * n);
}

}  // namespace grade
