#include "programs/times.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace grade {

namespace fs = std::filesystem;

namespace {

/// What a thread has waited for a processor [s]; 0 where the system does not tell.
double delay_of(const std::string& thread) {
    std::ifstream schedule(thread + "/schedstat");
    double computed = 0, delayed = 0;
    schedule >> computed >> delayed;
    return delayed * 1e-9;
}

}  // namespace

Times times_of(int pid) {
    const std::string place = fmt::format("/proc/{}/", pid);
    std::ifstream stat(place + "stat");
    std::string text;
    std::getline(stat, text, ')');  // the program's name is its own
    double ticks = 0;
    for (int field = 3; stat >> text; ++field)
        if (field >= 14 && field <= 17) ticks += std::strtod(text.c_str(), nullptr);
    Times times{ticks / double(sysconf(_SC_CLK_TCK)), 0};
    std::error_code error;
    for (fs::directory_iterator thread(place + "task", error), end; !error && thread != end; thread.increment(error)) {
        times.delayed += delay_of(thread->path());
        std::ifstream children(thread->path() / "children");
        for (int child; children >> child;) {
            const Times more = times_of(child);
            times.computed += more.computed, times.delayed += more.delayed;
        }
    }
    return times;
}

double own_delay() { return delay_of("/proc/thread-self"); }

}  // namespace grade
