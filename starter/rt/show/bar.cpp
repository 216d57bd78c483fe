#include "rt/show/bar.h"

#include <fmt/format.h>

#include <cstdio>

namespace rt {

void show_bar(Real done, Real seconds_left, bool stopping) {
    const int width = 40, full = int(done * width);
    const auto bar = std::string(std::size_t(full), '#') + std::string(std::size_t(width - full), '.');
    const auto left = seconds_left < 1e6 ? fmt::format("{:.0f} s left", seconds_left) : std::string();
    fmt::print(stderr, "\r[{}] {:3.0f} % {}{}\033[K", bar, 100 * done, left, stopping ? ", stopping" : "");
    std::fflush(stderr);
}

void clear_bar() {
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
}

}  // namespace rt
