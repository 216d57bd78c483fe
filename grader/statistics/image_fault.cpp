#include "statistics/image_fault.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <set>

#include <fmt/format.h>

namespace grade {

std::optional<ImageFault> image_fault(const rt::Image& image, int width, int height) {
    const auto failed = [](std::string words) {
        return ImageFault{Verdict::failed, std::move(words), Trouble::no_radiance};
    };
    if (image.width != width || image.height != height)
        return failed(
            fmt::format("the image has {} x {} pixels; expected {} x {}", image.width, image.height, width, height));
    if (image.pixels.size() != std::size_t(width) * height)
        return failed(
            fmt::format("the image has {} pixels; expected {}", image.pixels.size(), std::size_t(width) * height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                const double value = image.at(x, y)[channel];
                if (std::isfinite(value) && value >= 0) continue;
                const char* fault = std::isnan(value) ? "not a number" : std::isinf(value) ? "infinite" : "negative";
                return ImageFault{
                    std::isfinite(value) ? Verdict::failed : Verdict::not_finite,
                    fmt::format("pixel ({}, {}), channel {}, is {} ({})", x, y, "RGB"[channel], fault, value),
                    std::isnan(value) ? Trouble::not_a_number : Trouble::no_radiance};
            }
    return std::nullopt;
}

namespace {

bool on_level(double value) {
    const double level = 255 * value;
    return value <= 1 && std::abs(level - std::round(level)) < 1e-4;
}

double to_srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

}  // namespace

bool is_quantised(const rt::Image& image) {
    std::set<double> values;
    bool linear = true, srgb = true;
    for (const rt::Color& c : image.pixels)
        for (int channel = 0; channel < 3; ++channel) {
            values.insert(c[channel]);
            linear = linear && on_level(c[channel]);
            srgb = srgb && on_level(to_srgb(c[channel]));
            if (!linear && !srgb) return false;
        }
    return values.size() >= 16;
}

bool is_same(const rt::Image& a, const rt::Image& b) {
    if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size()) return false;
    for (std::size_t k = 0; k < a.pixels.size(); ++k)
        for (int channel = 0; channel < 3; ++channel)
            if (std::bit_cast<std::uint64_t>(a.pixels[k][channel]) !=
                std::bit_cast<std::uint64_t>(b.pixels[k][channel]))
                return false;
    return true;
}

}  // namespace grade
