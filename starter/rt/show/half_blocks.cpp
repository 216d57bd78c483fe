#include <fmt/format.h>

#include <algorithm>

#include "rt/show/encode.h"

namespace rt {

std::vector<std::string> half_blocks(const Shown& s) {
    constexpr const char* upper_half = "\u2580";
    std::vector<std::string> lines;
    for (int y = 0; y < s.height; y += 2) {
        const bool below = y + 1 < s.height;
        std::string line;
        const std::uint8_t *ink = nullptr, *ground = nullptr;  // colours in use
        const auto use = [&](const std::uint8_t*& used, const std::uint8_t* rgb, int code) {
            if (!used || !std::equal(rgb, rgb + 3, used))
                line += fmt::format("\033[{};2;{};{};{}m", code, rgb[0], rgb[1], rgb[2]);
            used = rgb;
        };
        for (int x = 0; x < s.width; ++x) {
            use(ink, s.at(x, y), 38);
            if (below) use(ground, s.at(x, y + 1), 48);
            line += upper_half;
        }
        lines.push_back(line + "\033[0m");
    }
    return lines;
}

}  // namespace rt
