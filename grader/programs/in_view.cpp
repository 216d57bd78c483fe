#include "programs/in_view.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "files/files.h"
#include "protocol/bytes.h"
#include "protocol/protocol.h"
#include "protocol/width.h"

namespace grade {

namespace {

constexpr double patience_of_debugger = 600;  // CPU seconds

/// Runs a command with this program's own stdout and stderr; stdin and descriptor 3 are files. Returns its status.
int run_in_view(const std::vector<std::string>& command, const fs::path& in, const fs::path& results) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error(fmt::format("no process can be made: {}", std::strerror(errno)));
    if (child == 0) {
        std::vector<char*> words;
        for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
        words.push_back(nullptr);
        const int from = in.empty() ? STDIN_FILENO : open(in.c_str(), O_RDONLY);
        const int to = results.empty() ? 3 : open(results.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (from < 0 || to < 0) _exit(127);
        if (from != STDIN_FILENO) dup2(from, STDIN_FILENO);
        if (to != 3) dup2(to, 3);
        execvp(words[0], words.data());
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

Fault why_no_answer(int status, double seconds) {
    if (!WIFSIGNALED(status)) return {Verdict::crashed, "it ended before", {}};
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL || signal == SIGALRM || signal == SIGPROF)
        return {Verdict::timed_out,
                fmt::format("it took longer than {:g} s: look for a loop or a recursion that does not end", seconds),
                {}};
    return {Verdict::crashed, signal_in_words(signal), {}};
}

/// What the child was asked to say: the row of the answer is in its last frame; none: there is no such frame.
std::optional<Outcome<Row>> answer_in(const std::string& bytes, std::size_t width) {
    std::optional<Outcome<Row>> answer;
    for (std::size_t at = 0; at + sizeof(FrameHeader) <= bytes.size();) {
        FrameHeader header{};
        std::memcpy(&header, bytes.data() + at, sizeof header);
        at += sizeof header;
        if (header.check != FrameHeader{}.check || header.bytes > bytes.size() - at) break;
        const std::string payload = bytes.substr(at, header.bytes);
        if (header.kind == FrameKind::error) return Fault{Verdict::crashed, "threw an exception: " + payload, {}};
        const auto numbers = header.kind == FrameKind::rows ? numbers_of_bytes(payload) : std::vector<double>();
        Rows rows;
        const bool are_rows = !numbers.empty() && unflatten(std::span(numbers).subspan(1), rows);
        if (are_rows && rows.size() == 1 && rows.front().size() == width) answer = rows.front();
        at += header.bytes;
    }
    return answer;
}

}  // namespace

Outcome<Row> call_in_view(const fs::path& program, const std::string& fragment, const Row& row, double seconds,
                          bool debugger) {
    const fs::path request = program.parent_path() / "request", results = program.parent_path() / "results";
    write_text(request,
               frame(FrameKind::fragment, fragment) + frame(FrameKind::rows, bytes_of<double>(flatten({row}))));
    int status = 0;
    if (debugger)
        run_in_view({"gdb", "-q", "-ex", "set breakpoint pending on", "-ex", "break rt::" + fragment, "-ex",
                     fmt::format("run {:g} < {} 3> {}", patience_of_debugger, request.string(), results.string()),
                     program.string()},
                    {}, {});
    else
        status = run_in_view({program.string(), fmt::format("{:g}", seconds)}, request, results);
    const auto answer = answer_in(read_text(results).value_or(""), width_of(fragment));
    return answer ? *answer : why_no_answer(status, seconds);
}

}  // namespace grade
