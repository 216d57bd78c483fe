#pragma once

#include <cstdio>
#include <cstdlib>

/// Ends a target where something does not hold, so that the driver tells the case.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}
