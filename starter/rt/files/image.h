#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rt/math.h"

/// Nobody needs this file for the assignment.
namespace rt {

/// Linear RGB pixels, row by row from the top left corner.
struct Image {
    int width = 0, height = 0;
    std::vector<Color> pixels;  // width * height

    Image() = default;
    Image(int width, int height) : width(width), height(height), pixels(std::size_t(width) * height, Color(0)) {}
    Color& at(int x, int y) { return pixels[std::size_t(y) * width + x]; }
    const Color& at(int x, int y) const { return pixels[std::size_t(y) * width + x]; }
};

/// What an EXR file says of its picture.
struct Label {
    ivec2 corner{0};  // of the picture in the film: its data window
    ivec2 film{0};    // size of the film, the display window; 0: the picture is all of it
    std::vector<std::pair<std::string, std::variant<int, double, std::string>>> attributes{};  // name and value
};

/// Writes FLOAT channels R, G, B. Throws std::runtime_error that names the path and the cause; an older file at the
/// path stays whole until the new one is complete.
void write_exr(const std::string& path, const Image& image, const Label& label = {});

/// A number for the pixels as an EXR file holds them: equal pictures have equal hashes, whenever and however they were
/// made.
std::uint64_t hash_of(const Image& image);

/// A channel as a screen shows it; a NaN is black.
std::uint8_t to_srgb(Real linear);

/// Writes an 8-bit sRGB preview of exposure * image. Errors as write_exr.
void write_png(const std::string& path, const Image& image, Real exposure = 1);

/// The same preview as bytes of a PNG file.
std::string png_bytes(const Image& image, Real exposure = 1);

}  // namespace rt
