#pragma once

#include <string>
#include <vector>

#include "rt/math.h"

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

/// Writes FLOAT channels R, G, B. Throws std::runtime_error that names the path and the cause; an older file at the
/// path stays whole until the new one is complete.
void write_exr(const std::string& path, const Image& image);

/// Reads channels R, G, B. Throws std::runtime_error that names the path and the cause.
Image read_exr(const std::string& path);

/// Writes an 8-bit sRGB preview of exposure * image. Errors as write_exr.
void write_png(const std::string& path, const Image& image, Real exposure = 1);

/// The same preview as bytes of a PNG file.
std::string png_bytes(const Image& image, Real exposure = 1);

}  // namespace rt
