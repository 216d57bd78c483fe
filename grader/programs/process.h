#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "programs/times.h"
#include "programs/walls.h"

/// Programs run under limits, their output bounded. The grader never opens a file that one of them wrote.
namespace grade {

struct Limits {
    double cpu_seconds = 10;       // of each process; SIGXCPU when reached
    double most_cpu_seconds = 10;  // how far a process may raise that itself
    double wall_seconds = 30;
    std::uint64_t memory = 4ull << 30;    // bytes of address space of each process; 0: any number
    std::uint64_t file_size = 64u << 20;  // bytes of each file
    std::size_t output = 64u << 10;       // bytes of stdout and of stderr that are kept; the rest is thrown away
    std::uint64_t processes = 8192;       // of the user
};

/// How a program ended, and what it said.
struct Ending {
    enum class How { exited, signalled, timed_out, not_run };
    How how = How::not_run;
    int code = 0;            // exit code, or number of the signal
    std::string out, err;    // the first bytes of each
    double cpu_seconds = 0;  // of the program and all that it started
    bool waited = false;     // timed out by wall time, not by CPU time

    bool good() const { return how == How::exited && code == 0; }
};

using Clock = std::chrono::steady_clock;

/// A running program, with ways to its stdin and from its stdout, stderr, and descriptor 3: sockets, which nobody can
/// open again by a name. Its environment is empty but for PATH, LANG and options of sanitizers. When this object goes,
/// so do the program and everything in its process group. The grader starts processes here, and in in_view.h.
class Process {
public:
    /// folder  its working directory
    /// Throws std::runtime_error where no process can be made.
    Process(const std::vector<std::string>& arguments, const Limits& limits, const std::string& folder,
            Walls walls = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Sends all bytes to its stdin. false: it ended or the deadline passed.
    bool send(std::string_view bytes, Clock::time_point deadline);

    /// Receives exactly that many bytes from its descriptor 3. None: it ended or the deadline passed.
    std::optional<std::string> receive(std::size_t bytes, Clock::time_point deadline);

    /// Until now, of the program and of all that it started and that still run.
    Times times() const;

    /// Nothing more comes on its stdin.
    void hang_up();

    /// Waits until it ends, or kills it at the deadline. This and the two above give a program that computes more time:
    /// its CPU time is limited. Who let one of theirs pass has timed out, however it ends now.
    Ending finish(Clock::time_point deadline);

private:
    /// Moves what can be moved until that is enough, the program ended, or the deadline passed.
    bool pump(std::string_view bytes, std::size_t wanted, bool to_the_end, Clock::time_point deadline);
    /// At a deadline: whether it has hardly wanted a processor in the last so many seconds, or computed through more
    /// than a half of them since it met the first one, which no limit on its CPU time has stopped.
    bool is_over(double seconds);
    void kill_all() const;

    Limits limits_;
    int pid_ = -1, watch_ = -1;  // watch: readable when the program has ended
    int in_ = -1, out_ = -1, err_ = -1, results_ = -1;
    std::string out_text_, err_text_, received_;
    std::optional<Ending> ending_;
    double busy_ = 0;                   // at the last deadline [s]
    double delayed_ = 0;                // at the last look [s]: who has ended tells it no more
    std::optional<double> computed_;    // at the first one [s]
    bool waits_ = true, late_ = false;  // late: a deadline for its answer has passed
};

/// Runs a program to its end; its stdin is empty. For what is the grader's own: a student's goes through sandbox.h.
Ending run(const std::vector<std::string>& arguments, const Limits& limits, const std::string& folder);

/// In so many seconds.
Clock::time_point in_seconds(double seconds);

/// "a segmentation fault (SIGSEGV)" for 11.
std::string signal_in_words(int signal);

}  // namespace grade
