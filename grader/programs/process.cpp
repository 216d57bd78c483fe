#include "programs/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/close_range.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "files/interrupt.h"

namespace grade {

namespace {

/// A pair of sockets: one end is the grader's, one goes to the program.
struct SocketPair {
    int here = -1, there = -1;

    SocketPair() {
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
            throw std::runtime_error(fmt::format("no way to a program: {}; expected more free descriptors (ulimit -n)",
                                                 std::strerror(errno)));
        here = ends[0], there = ends[1];
    }
    ~SocketPair() {
        for (const int end : {here, there})
            if (end >= 0) close(end);
    }
    SocketPair(const SocketPair&) = delete;
    SocketPair& operator=(const SocketPair&) = delete;

    int take() { return std::exchange(here, -1); }
};

void close_one(int& descriptor) {
    if (descriptor >= 0) close(descriptor);
    descriptor = -1;
}

void limit(int resource, rlim_t soft, rlim_t hard) {
    rlimit now{};
    getrlimit(__rlimit_resource_t(resource), &now);
    const rlimit next{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
    setrlimit(__rlimit_resource_t(resource), &next);
}

/// In the new process, between fork and exec: only calls that are safe there.
void apply(const Limits& limits) {
    limit(RLIMIT_CPU, rlim_t(std::ceil(limits.cpu_seconds)), rlim_t(std::ceil(limits.most_cpu_seconds)) + 1);
#ifndef __SANITIZE_ADDRESS__  // it reserves terabytes of addresses
    if (limits.memory > 0) limit(RLIMIT_AS, limits.memory, limits.memory);
#endif
    limit(RLIMIT_FSIZE, limits.file_size, limits.file_size);
    limit(RLIMIT_NPROC, limits.processes, limits.processes);
    limit(RLIMIT_NOFILE, 256, 256);
    limit(RLIMIT_CORE, 0, 0);
}

/// Appends what is there to text, up to its bound. false: the other end is closed.
bool drain(int descriptor, std::string& text, std::size_t most) {
    std::array<char, 65536> buffer;
    const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    if (got == 0) return false;
    text.append(buffer.data(), std::min(std::size_t(got), most - std::min(most, text.size())));
    return true;
}

int milliseconds_until(Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    return int(std::clamp<long long>(left, 0, 1 << 30));
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const Limits& limits, const std::string& folder,
                 Walls walls)
    : limits_(limits) {
    static const auto ignored = std::signal(SIGPIPE, SIG_IGN);
    static const int adopts = prctl(PR_SET_CHILD_SUBREAPER, 1);  // what loses its parent comes to the grader
    (void)ignored, (void)adopts;

    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    char path[] = "PATH=/usr/local/bin:/usr/bin:/bin", language[] = "LANG=C.UTF-8";
    char address[] = "ASAN_OPTIONS=detect_leaks=0:handle_abort=1:mmap_limit_mb=2048";
    char undefined[] = "UBSAN_OPTIONS=print_stacktrace=1";
    std::string temporary = "TMPDIR=" + folder;
    std::array<char*, 6> environment{path,   language, address, undefined, walls.itself ? temporary.data() : nullptr,
                                     nullptr};

    SocketPair in, out, err, results, calls;
    const bool hands_over = !walls.itself && !walls.calls.code.empty();
    if (hands_over && ::write(calls.here, walls.calls.code.data(), walls.calls.code.size() * sizeof(sock_filter)) < 0)
        throw std::runtime_error(fmt::format("no filter of system calls: {}", std::strerror(errno)));
    const pid_t grader = getpid();
    pid_ = fork();
    if (pid_ == 0) {
        setsid();
        prctl(PR_SET_PDEATHSIG, SIGKILL);     // nothing outlives the grader
        if (getppid() != grader) _exit(127);  // it has died already
        // the ends may sit on each other's places: lift them first
        std::array<int, 5> ends{in.there, out.there, err.there, results.there, calls.there};
        for (int& end : ends) end = fcntl(end, F_DUPFD, 16);
        if (walls.files >= 0) walls.files = fcntl(walls.files, F_DUPFD, 16);
        for (int i = 0; i < 5; ++i) dup2(ends[std::size_t(i)], i);
        syscall(SYS_close_range, hands_over ? 5u : 4u, ~0u, CLOSE_RANGE_CLOEXEC);
        if (chdir(folder.c_str()) != 0) _exit(127);
        umask(022);
        std::signal(SIGPIPE, SIG_DFL);
        apply(limits);
        if (walls.itself && !walls.lock_in()) _exit(127);
        execve(argv[0], argv.data(), environment.data());
        _exit(127);
    }
    if (pid_ < 0)
        throw std::runtime_error(
            fmt::format("no process: {}; expected fewer of this user (ulimit -u)", std::strerror(errno)));
    in_ = in.take(), out_ = out.take(), err_ = err.take(), results_ = results.take();
    watch_ = int(syscall(SYS_pidfd_open, pid_, 0));
    for (const int end : {in_, out_, err_, results_}) fcntl(end, F_SETFL, O_NONBLOCK);
}

Process::~Process() {
    if (!ending_) finish(Clock::now());
    for (int* end : {&in_, &out_, &err_, &results_, &watch_}) close_one(*end);
}

void Process::kill_all() const {
    kill(-pid_, SIGKILL);
    kill(pid_, SIGKILL);
}

Times Process::times() const {
    const Times now = times_of(pid_);
    return {now.computed, std::max(now.delayed, delayed_)};
}

bool Process::is_over(double seconds) {
    const Times now = times();
    const double busy = now.computed + now.delayed, before = std::exchange(busy_, busy);
    if (!computed_) computed_ = now.computed;
    waits_ = busy - before < 0.05 * seconds;
    return waits_ || now.computed - *computed_ > 0.5 * seconds;
}

bool Process::pump(std::string_view bytes, std::size_t wanted, bool to_the_end, Clock::time_point deadline) {
    const auto given = deadline - Clock::now();
    while (true) {
        if (!to_the_end && bytes.empty() && received_.size() >= wanted) return true;
        if (!to_the_end && wanted > received_.size() && results_ < 0) return false;
        if (Clock::now() > deadline) {
            // the machine may be busy: who computes, or would if it could, is stopped by its CPU time
            if (given < std::chrono::seconds(1) || is_over(std::chrono::duration<double>(given).count()))
                return late_ = true, false;
            deadline += given;
        }
        if (!to_the_end) check_interrupt();
        const std::size_t room = std::max(wanted, received_.size());
        std::array<pollfd, 5> events{{{bytes.empty() ? -1 : in_, POLLOUT, 0},
                                      {out_, POLLIN, 0},
                                      {err_, POLLIN, 0},
                                      {wanted > received_.size() || to_the_end ? results_ : -1, POLLIN, 0},
                                      {watch_, POLLIN, 0}}};
        const int count = poll(events.data(), events.size(), std::min(milliseconds_until(deadline), 250));
        if (count < 0 && errno != EINTR) return false;
        if (count == 0) delayed_ = times().delayed;
        if (count == 0) continue;

        bool moved = false;
        const auto pull = [&](std::size_t which, int& end, std::string& text, std::size_t most) {
            if (events[which].fd < 0 || events[which].revents == 0) return;
            moved = true;
            if (!drain(end, text, most)) close_one(end);
        };
        pull(1, out_, out_text_, limits_.output);
        pull(2, err_, err_text_, limits_.output);
        if (events[3].revents != 0) {
            // never more than was asked for, so that what comes unasked stays in the pipe
            std::array<char, 65536> buffer;
            const std::size_t ask = to_the_end ? buffer.size() : std::min(buffer.size(), room - received_.size());
            const ssize_t got = ::read(results_, buffer.data(), ask);
            if (got == 0) close_one(results_);
            if (got > 0 && !to_the_end) received_.append(buffer.data(), std::size_t(got));
            moved = got > 0;
        }
        if (events[0].revents != 0) {
            const ssize_t sent = ::write(in_, bytes.data(), bytes.size());
            if (sent > 0) bytes.remove_prefix(std::size_t(sent));
            if (sent < 0 && errno != EAGAIN && errno != EINTR) close_one(in_);
            moved = moved || sent > 0;
        }
        if (events[4].revents != 0 && !moved) return to_the_end;
        if (!bytes.empty() && in_ < 0) return false;
    }
}

bool Process::send(std::string_view bytes, Clock::time_point deadline) { return pump(bytes, 0, false, deadline); }

std::optional<std::string> Process::receive(std::size_t bytes, Clock::time_point deadline) {
    if (!pump({}, bytes, false, deadline)) return std::nullopt;
    return std::exchange(received_, {});
}

void Process::hang_up() { close_one(in_); }

Ending Process::finish(Clock::time_point deadline) {
    if (ending_) return *ending_;
    hang_up();
    const bool ended = pump({}, 0, true, deadline) && !late_;  // at a hang-up who is late may still end by itself
    Ending ending;
    ending.out = out_text_, ending.err = err_text_;
    ending.cpu_seconds = ended ? 0 : times().computed;
    ending.waited = !ended && waits_;
    // the program is at most a zombie now, which keeps its number from being given to another
    kill_all();
    int status = 0;
    rusage usage{};
    while (wait4(pid_, &status, 0, &usage) < 0 && errno == EINTR) {}
    for (int tries = 0; tries < 5000 && kill(-pid_, 0) == 0; ++tries) {
        while (waitpid(-pid_, nullptr, __WALL) > 0) {}
        if (kill(-pid_, SIGKILL) == 0) usleep(1000);
    }

    const auto seconds = [](timeval time) { return double(time.tv_sec) + double(time.tv_usec) * 1e-6; };
    ending.cpu_seconds = std::max(ending.cpu_seconds, seconds(usage.ru_utime) + seconds(usage.ru_stime));
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    if (!ended || signal == SIGXCPU || code == 128 + SIGXCPU) {
        ending.how = Ending::How::timed_out;
    } else if (signal != 0 || (code > 128 && code < 128 + 65)) {  // a shell or sandbox in between adds 128
        ending.how = Ending::How::signalled;
        ending.code = signal != 0 ? signal : code - 128;
    } else {
        ending.how = code == 127 ? Ending::How::not_run : Ending::How::exited;
        ending.code = code;
    }
    ending_ = ending;
    return ending;
}

Ending run(const std::vector<std::string>& arguments, const Limits& limits, const std::string& folder) {
    return Process(arguments, limits, folder).finish(in_seconds(limits.wall_seconds));
}

Clock::time_point in_seconds(double seconds) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

std::string signal_in_words(int signal) {
    const char* words = signal == SIGSEGV   ? "a segmentation fault: memory that is not the program's"
                        : signal == SIGABRT ? "an abort: a failed assertion, or an exception that nobody caught"
                        : signal == SIGFPE  ? "an arithmetic fault: an integer divided by zero"
                        : signal == SIGILL  ? "an illegal instruction: the end of a function that returns nothing"
                        : signal == SIGBUS  ? "a bus error"
                        : signal == SIGKILL
                            ? "a signal that nothing survives: it was sent by itself, or there was no memory left"
                            : strsignal(signal);
    const char* abbreviation = sigabbrev_np(signal);
    return fmt::format("{} (SIG{})", words, abbreviation ? abbreviation : std::to_string(signal));
}

}  // namespace grade
