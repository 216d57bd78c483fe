#pragma once

namespace grade {

/// Ctrl-C came: whoever works stops at the next step, and nothing that is done is lost. It is no std::exception: who
/// goes on after an error lets it pass.
struct Interrupted {};

/// From now on the first Ctrl-C ends work between two steps; the second one ends the program at once.
void stop_at_interrupt();

/// Throws Interrupted after Ctrl-C.
void check_interrupt();

}  // namespace grade
