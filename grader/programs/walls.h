#pragma once

#include <linux/filter.h>

#include <filesystem>
#include <vector>

/// What any process may ask of the kernel for itself and all that it starts: a filter of system calls, and rules for
/// files.
namespace grade {

/// A program for seccomp.
struct SystemCalls {
    std::vector<sock_filter> code;
    std::size_t own_number = 0;  // the instruction that takes the number of the process; 0: none does
};

/// What a program is locked into, in the order of these members.
struct Walls {
    bool itself = false;  // between fork and exec; else bubblewrap does it, and reads the filter on descriptor 4
    unsigned user = 0;    // becomes this user; 0: stays who it is, without any privilege
    int files = -1;       // a Landlock rule set
    SystemCalls calls;

    /// In the new process, between fork and exec. false: it did not work.
    bool lock_in();
};

enum class Starts { nothing, programs };

/// The system calls of a step: no namespaces, mounts, tracing, sockets, keys, io_uring, and no leaving of its process
/// group. Where it starts nothing, an attempt ends it with SIGSYS, and it changes no file's owner, mode or times.
/// Empty on a kind of processor that is not known here.
///
/// alone  the filter also keeps it from sending signals to others, which namespaces do better
SystemCalls allowed_calls(Starts starts, bool alone);

/// Version of Landlock's interface; 0: there is none.
int landlock_version();

/// A Landlock rule set: these files and folders are readable and can be run, this one is writable, and no other is
/// either; no TCP, no signals to others where the kernel knows these rules. -1: there is none.
int landlock_rules(const std::vector<std::filesystem::path>& readable,
                   const std::vector<std::filesystem::path>& writable);

}  // namespace grade
