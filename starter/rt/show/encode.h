#pragma once

#include <string>
#include <string_view>

#include "rt/files/image.h"

/// Pictures as what terminals draw. Nobody needs this file for the assignment.
namespace rt {

/// Pixels for a screen.
struct Shown {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  // sRGB, row by row from the top

    const std::uint8_t* at(int x, int y) const {
        return &rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
    }
};

/// The picture, times the exposure, made small enough for width x height pixels: each is the mean, in linear light, of
/// those that it stands for. No picture is made larger.
Shown shown(const Image& image, Real exposure, int width, int height);

/// Two pixels in each cell: the upper half block in one colour on a ground of the other. A line of text for two rows.
std::vector<std::string> half_blocks(const Shown& pixels);

/// kitty's graphics protocol: a PNG in pieces of base64, in the place of the last picture of this name, which stays
/// where the cursor is, and `rows` lines high; the cursor does not move.
///
/// Source: https://sw.kovidgoyal.net/kitty/graphics-protocol/
std::string kitty(std::string_view png, int rows);

/// Sixels: bands of six rows, in each of which the colours follow one another. 6 x 6 x 6 colours, dithered in an
/// ordered pattern, so that what does not change looks the same in each frame.
///
/// Source: Digital Equipment Corporation, "VT330/VT340 Programmer Reference Manual", volume 2, chapter 14, 1988.
std::string sixel(const Shown& pixels);

}  // namespace rt
