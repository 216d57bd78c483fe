#include "files/interrupt.h"

#include <csignal>

namespace grade {

namespace {

volatile std::sig_atomic_t interrupted = 0;

}  // namespace

void stop_at_interrupt() {
    struct sigaction action {};
    action.sa_handler = [](int) { interrupted = 1; };
    action.sa_flags = int(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
}

void check_interrupt() {
    if (interrupted) throw Interrupted();
}

}  // namespace grade
