#include "commands/commands.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstring>
#include <memory>

#include "commands/last_run.h"
#include "commands/words.h"
#include "diagnosis/calls.h"
#include "judging/breakdown.h"
#include "programs/cache.h"
#include "programs/process.h"
#include "programs/programs.h"
#include "programs/runner.h"
#include "protocol/bytes.h"
#include "protocol/protocol.h"

namespace grade {

namespace {

struct CallArguments {
    std::string fragment, arguments, submission;
    bool debugger = false, trusted = false;
};

constexpr double patience = 10, patience_of_debugger = 600;  // CPU seconds

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

std::string why_no_answer(int status) {
    if (!WIFSIGNALED(status)) return "it ended before";
    const int signal = WTERMSIG(status);
    return signal == SIGXCPU || signal == SIGKILL || signal == SIGALRM || signal == SIGPROF
               ? fmt::format("it took longer than {:g} s: look for a loop or a recursion that does not end", patience)
               : signal_in_words(signal);
}

/// What the child was asked to say: the row of the answer is in its last frame.
Row answer_in(const std::string& bytes) {
    Row answer;
    for (std::size_t at = 0; at + sizeof(FrameHeader) <= bytes.size();) {
        FrameHeader header{};
        std::memcpy(&header, bytes.data() + at, sizeof header);
        at += sizeof header;
        if (header.check != FrameHeader{}.check || header.bytes > bytes.size() - at) break;
        if (header.kind == FrameKind::error)
            throw SubmissionError("threw an exception: " + bytes.substr(at, header.bytes));
        if (header.kind == FrameKind::rows) {
            const std::vector<double> numbers = numbers_of_bytes(bytes.substr(at, header.bytes));
            std::vector<Row> rows;
            if (!numbers.empty() && unflatten(std::span(numbers).subspan(1), rows) && !rows.empty())
                answer = rows.front();
        }
        at += header.bytes;
    }
    return answer;
}

/// The arguments; without any, of what its user edits, those of the simplest call that was wrong in the last grading.
std::string words_of(const CallArguments& arguments, bool own, const Toolchain& chain) {
    const auto cache = own && arguments.arguments.empty() ? cache_folder(chain) : std::nullopt;
    return cache ? last_call(*cache / last_run_file, arguments.fragment) : arguments.arguments;
}

/// One call of a fragment, with the student's own prints, and what is expected. Returns the exit code: 0; 1 where the
/// answer is another.
int run_call(const CallArguments& arguments, const Context& context) {
    Toolchain chain = read_toolchain(context.toolchain);
    const Assignment assignment = assignment_of(chain);
    const Chosen chosen = choose(arguments.submission.empty() ? std::vector{arguments.fragment}
                                                              : std::vector{arguments.submission, arguments.fragment},
                                 chain, assignment);
    if (!chosen.own && !arguments.trusted)
        throw rt::InputError(arguments.submission +
                             ": a call runs without a sandbox; expected --trusted for code that is your own");
    if (chosen.fragments.empty()) throw rt::InputError(arguments.fragment + ": no fragment has this name");
    const auto signature =
        signature_of(arguments.fragment, read_text(chain.includes.front() / "rt/fragments.h").value_or(""));
    if (!signature) throw rt::InputError(arguments.fragment + ": fragments.h does not declare it");
    Row row;
    try {
        row = arguments_from_words(*signature, words_of(arguments, chosen.own, chain));
    } catch (const std::invalid_argument& error) {
        throw rt::InputError(error.what());
    }

    const Sandbox sandbox = find_sandbox(true);  // right away, and in the debugger, which is its user's
    const fs::path meshes = chain.source / "scenes";
    if (arguments.debugger) chain.compile.insert(chain.compile.end(), {"-g", "-O0"});
    BuildSettings build;
    build.trusted = true;
    Progress progress({});
    Programs programs(read_submission(chosen.submission, assignment.names()), chain, build, progress);
    programs.compile({arguments.fragment});
    if (const auto complaint = programs.complaint(arguments.fragment); !complaint.empty())
        throw SubmissionError(arguments.fragment + ": " + complaint);

    Runner solution(programs.with({}).program, sandbox, meshes, patience);
    const auto right = solution.probe(arguments.fragment, {row});
    if (const Fault* fault = std::get_if<Fault>(&right))
        throw std::runtime_error("the solution itself: " + fault->message);

    const fs::path program = programs.copy_for("call", programs.must_link({arguments.fragment}));
    const fs::path request = program.parent_path() / "request", results = program.parent_path() / "results";
    write_text(request, frame(FrameKind::fragment, arguments.fragment) +
                            frame(FrameKind::rows, bytes_of<double>(flatten({row}))));
    int status = 0;
    fmt::print("{}({})\n", arguments.fragment, arguments_in_words(*signature, row));
    if (arguments.debugger)
        run_in_view({"gdb", "-q", "-ex", "set breakpoint pending on", "-ex", "break rt::" + arguments.fragment, "-ex",
                     fmt::format("run {:g} < {} 3> {}", patience_of_debugger, request.string(), results.string()),
                     program.string()},
                    {}, {});
    else
        status = run_in_view({program.string(), fmt::format("{:g}", patience)}, request, results);
    const Row answer = answer_in(read_text(results).value_or(""));
    const Row& expected = std::get<Rows>(right).front();
    if (answer.size() != expected.size()) {
        const std::string place = arguments.debugger ? "" : breakdown_of(programs, chain, arguments.fragment, {row});
        fmt::print("no answer: {}\n{}{}must be {}\n", why_no_answer(status), place, place.empty() ? "" : "\n",
                   result_in_words(*signature, expected));
        return 1;
    }
    fmt::print("answer  {}\nmust be {}\n", result_in_words(*signature, answer), result_in_words(*signature, expected));
    return is_equal(signature->of_result(expected), answer, expected) ? 0 : 1;
}

}  // namespace

Command call_command(CLI::App& app) {
    const auto arguments = std::make_shared<CallArguments>();
    CLI::App* call =
        app.add_subcommand("call", "call a fragment with arguments that a hint shows: your answer, and the right one");
    call->add_option("FRAGMENT", arguments->fragment, "its name")->required();
    call->add_option("ARGUMENTS", arguments->arguments,
                     "\"d = (0, 0, -1), n = (0, 0, 1)\", fields as \"camera.focus = 2\"; what is not named has its "
                     "default; without: the simplest call that was wrong in the last grading of the starter");
    call->add_option("--of", arguments->submission, "a folder; default: starter")->type_name("SUBMISSION");
    call->add_flag("--trusted", arguments->trusted, "of code that is your own: it runs without a sandbox");
    call->add_flag("--gdb", arguments->debugger, "in the debugger, which stops where the fragment begins");
    return {call, [arguments](const Context& context) { return run_call(*arguments, context); }};
}

}  // namespace grade
