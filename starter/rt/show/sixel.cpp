#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "rt/show/encode.h"

namespace rt {
namespace {

constexpr int levels = 6, colors = levels * levels * levels;

/// Where a pixel's threshold is between two levels, 0 < t < 1: Bayer's pattern of 4 x 4.
double threshold(int x, int y) {
    constexpr int order[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    return (order[y & 3][x & 3] + 0.5) / 16;
}

int color_at(const Shown& s, int x, int y) {
    const std::uint8_t* rgb = s.at(x, y);
    int color = 0;
    for (int i = 0; i < 3; ++i) color = levels * color + int(rgb[i] / 255.0 * (levels - 1) + threshold(x, y));
    return color;
}

/// Equal characters that follow each other are counted.
void append_run(std::string& out, int count, char c) {
    if (count > 3)
        out += fmt::format("!{}{}", count, c);
    else
        out.append(std::size_t(count), c);
}

}  // namespace

std::string sixel(const Shown& s) {
    std::string out = fmt::format("\033P0;1;0q\"1;1;{};{}", s.width, s.height);
    const auto percent = [](int level) { return 100 * level / (levels - 1); };
    for (int c = 0; c < colors; ++c)
        out += fmt::format("#{};2;{};{};{}", c, percent(c / levels / levels), percent(c / levels % levels),
                           percent(c % levels));

    for (int top = 0; top < s.height; top += 6) {
        std::array<std::vector<char>, colors> bits;  // of each column, where the band has the colour
        for (int y = top; y < std::min(top + 6, s.height); ++y)
            for (int x = 0; x < s.width; ++x) {
                auto& column = bits[std::size_t(color_at(s, x, y))];
                column.resize(std::size_t(s.width));
                column[std::size_t(x)] = char(column[std::size_t(x)] | 1 << (y - top));
            }
        for (int c = 0; c < colors; ++c) {
            const std::vector<char>& column = bits[std::size_t(c)];
            if (column.empty()) continue;
            out += fmt::format("#{}", c);
            for (std::size_t x = 0, end; x < column.size(); x = end) {
                for (end = x; end < column.size() && column[end] == column[x];) ++end;
                append_run(out, int(end - x), char(63 + column[x]));
            }
            out += '$';  // back to the left edge
        }
        out += '-';  // the next band
    }
    return out + "\033\\";
}

}  // namespace rt
