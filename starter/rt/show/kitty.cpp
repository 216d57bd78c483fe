#include <fmt/format.h>

#include <algorithm>

#include "rt/show/encode.h"

namespace rt {
namespace {

constexpr std::size_t piece = 4096;  // characters at once, at most

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? std::uint8_t(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string kitty(std::string_view png, int rows) {
    const std::string text = base64(png);
    std::string out;
    for (std::size_t i = 0; i < text.size(); i += piece) {
        // a=T: send and show; f=100: PNG; i, p: image 1 in its place 1; q=2: no answers; C=1: the cursor stays; m: more
        // follows
        const std::string head = i == 0 ? fmt::format("a=T,f=100,i=1,p=1,q=2,C=1,r={},", rows) : "q=2,";
        out += fmt::format("\033_G{}m={};{}\033\\", head, int(i + piece < text.size()), text.substr(i, piece));
    }
    return out;
}

}  // namespace rt
