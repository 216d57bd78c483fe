#include "rt/show/bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "rt/show/terminal.h"

namespace rt {

void show_bar(Real done, Real seconds_left, bool stopping) {
    const auto left = seconds_left < 1e6 ? fmt::format("{:.0f} s left", seconds_left) : std::string();
    const auto words = fmt::format(" {:3.0f} % {}{}", 100 * done, left, stopping ? ", stopping" : "");
    // A line that is longer than the terminal is wide would become two.
    const int room = size_of_terminal(STDERR_FILENO).columns - 1;
    const int width = std::clamp(room - int(words.size()) - 2, 0, 40), full = int(done * width);
    const auto bar = std::string(std::size_t(full), '#') + std::string(std::size_t(width - full), '.');
    fmt::print(stderr, "\r{}\033[K", fmt::format("[{}]{}", bar, words).substr(0, std::size_t(room)));
    std::fflush(stderr);
}

void clear_bar() {
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
}

}  // namespace rt
