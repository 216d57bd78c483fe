#include <cstdio>
#include <mutex>
#include <set>
#include <string>

#include "rt/fragments.h"

namespace rt {

void report_not_started(const char* file, int line) {
    // A blank is called for every ray: ask its thread first, then all threads.
    thread_local std::set<const char*> seen;
    if (!seen.insert(file).second) return;
    static std::mutex mutex;
    static std::set<std::string> reported;
    const std::lock_guard lock(mutex);
    if (reported.insert(file).second) std::fprintf(stderr, "%s:%d: not started\n", file, line);
}

}  // namespace rt
