#include "commands/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "commands/last_run.h"
#include "commands/words.h"
#include "diagnosis/calls/calls.h"
#include "judging/breakdown.h"
#include "programs/cache.h"
#include "programs/in_view.h"
#include "programs/programs.h"

namespace grade {

namespace {

struct CallArguments {
    std::string fragment, arguments, submission;
    bool debugger = false, trusted = false;
};

constexpr double patience = 10;  // CPU seconds

/// The arguments; without any, of what its user edits, those of the simplest call that was wrong in the last grading.
std::string words_of(const CallArguments& arguments, bool own, const Toolchain& chain) {
    const auto cache = own && arguments.arguments.empty() ? cache_folder(chain) : std::nullopt;
    return cache ? last_call(*cache / last_run_file, arguments.fragment) : arguments.arguments;
}

/// Whether an answer lies elsewhere than the solution's, as random numbers may be used in another way.
bool may_be_another_sample(const Signature& signature, const Row& answer, const Row& expected) {
    const Layout result = signature.of_result(expected);
    const auto is_other = [&](const Field& part) { return is_place(part) && !is_equal(part, answer, expected); };
    return std::ranges::count(signature.arguments, "u", &Signature::Argument::name) > 0 &&
           std::ranges::all_of(answer, [](double x) { return std::isfinite(x); }) &&
           std::ranges::any_of(result.parts, is_other);
}

/// One call of a fragment, with the student's own prints, and what is expected. Returns the exit code: 0; 1 where the
/// answer is another, and no other is as good.
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
    fmt::print("{}({})\n", arguments.fragment, arguments_in_words(*signature, row));
    const auto mine = call_in_view(program, arguments.fragment, row, patience, arguments.debugger);
    const Row& expected = std::get<Rows>(right).front();
    const std::string due = result_in_words(*signature, expected);
    if (const Fault* fault = std::get_if<Fault>(&mine)) {
        const std::string place = arguments.debugger ? "" : breakdown_of(programs, chain, arguments.fragment, {row});
        fmt::print("no answer: {}\n{}{}must be {}\n", fault->message, place, place.empty() ? "" : "\n", due);
        return 1;
    }
    const Row& answer = std::get<Row>(mine);
    if (may_be_another_sample(*signature, answer, expected)) {
        fmt::print("answer  {}\nsolution {}; another map is as good: ./grade {} asks\n",
                   result_in_words(*signature, answer), due, arguments.fragment);
        return 0;
    }
    fmt::print("answer  {}\nmust be {}\n", result_in_words(*signature, answer), due);
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
