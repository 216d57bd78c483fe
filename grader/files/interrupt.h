#pragma once

#include <stdexcept>

namespace grade {

/// Ctrl-C came: whoever works stops at the next step, and nothing that is done is lost.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

/// From now on the first Ctrl-C ends work between two steps; the second one ends the program at once.
void stop_at_interrupt();

/// Throws Interrupted after Ctrl-C.
void check_interrupt();

}  // namespace grade
