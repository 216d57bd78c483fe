#include <fmt/format.h>

#include "rt/files/words.h"
#include "rt/show/encode.h"

namespace rt {
namespace {

constexpr std::size_t piece = 4096;  // characters at once, at most

}  // namespace

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
