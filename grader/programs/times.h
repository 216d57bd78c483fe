#pragma once

namespace grade {

struct Times {
    double computed = 0,
           delayed = 0;  // CPU time; what threads waited for a processor, which is the machine's doing [s]
};

/// Until now, of a process and of all that come from it and still run.
Times times_of(int pid);

/// What the calling thread has waited for a processor so far [s].
double own_delay();

}  // namespace grade
