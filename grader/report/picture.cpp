#include "report/picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rt/files/words.h"

namespace grade {

namespace {

double luminance(rt::Color c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

/// Of a colour of the screen, 0 to 255 each.
rt::Color linear(double r, double g, double b) {
    const auto one = [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
    return {one(r / 255), one(g / 255), one(b / 255)};
}

/// What most of a picture is darker than.
double bright(const rt::Image& image) {
    std::vector<double> values;
    for (const rt::Color& pixel : image.pixels) values.push_back(luminance(pixel));
    const auto place = values.begin() + std::ptrdiff_t(values.size() * 9 / 10);
    std::nth_element(values.begin(), place, values.end());
    return *place > 0 ? *place : *std::max_element(values.begin(), values.end());
}

}  // namespace

std::string data_uri(const rt::Image& image, double exposure) {
    return "data:image/png;base64," + rt::base64(rt::png_bytes(image, exposure));
}

double preview_exposure(const rt::Image& image) {
    const double level = bright(image);
    return level > 0 && std::isfinite(level) ? 0.6 / level : 1;
}

rt::Image scaled(const rt::Image& image, double factor) {
    rt::Image result = image;
    for (rt::Color& pixel : result.pixels) pixel *= factor;
    return result;
}

rt::Image side_by_side(const std::vector<rt::Image>& pictures) {
    constexpr int gap = 8;
    int width = -gap, height = 0;
    for (const rt::Image& picture : pictures) width += picture.width + gap, height = std::max(height, picture.height);
    rt::Image row(width, height);
    std::ranges::fill(row.pixels, rt::Color(1));
    int left = 0;
    for (const rt::Image& picture : pictures) {
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) row.at(left + x, y) = picture.at(x, y);
        left += picture.width + gap;
    }
    return row;
}

namespace {

/// From blue, -1, over white to orange, 1.
rt::Color on_scale(double x) {
    const rt::Color blue = linear(0, 90, 181), white(1), orange = linear(220, 95, 0);
    x = std::clamp(x, -1.0, 1.0);
    return white + std::abs(x) * ((x < 0 ? blue : orange) - white);
}

}  // namespace

Difference significance(const Tiles& tiles, int width, int height) {
    Difference map{rt::Image(width, height), 10};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            map.image.at(x, y) =
                on_scale(tiles.t[std::size_t(y / Tiles::side * tiles.columns + x / Tiles::side)] / map.full);
    return map;
}

Difference difference(const rt::Image& picture, const rt::Image& truth) {
    const double level = std::max(bright(truth), bright(picture) / 16);
    Difference map{rt::Image(picture.width, picture.height), level > 0 ? level / 4 : 1};
    for (std::size_t k = 0; k < picture.pixels.size(); ++k)
        map.image.pixels[k] = on_scale((luminance(picture.pixels[k]) - luminance(truth.pixels[k])) / map.full);
    return map;
}

}  // namespace grade
