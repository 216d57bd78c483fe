#include "commands/commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "commands/exit_code.h"
#include "commands/words.h"
#include "studies/studies.h"

namespace grade {

namespace {

/// Becomes the second program, with the same words. Returns the exit code where that is not there: 3.
int start_study(const Study& study, char** argv) {
    std::error_code error;
    const std::string program = fs::read_symlink("/proc/self/exe", error).string() + "_studies";
    execv(program.c_str(), argv);
    if (fs::exists(program, error))
        fmt::print(stderr, "{}: cannot be started; grade {} is in it\n", program, study.name);
    else
        fmt::print(stderr,
                   "grade {0} is in a program of its own, {1}, which is not built yet: ./grade {0} builds it, and so "
                   "does cmake --build --preset release --target grade_studies\n",
                   study.name, program);
    return infrastructure;
}

}  // namespace

int run_command_line(int argc, char** argv) {
    CLI::App app("Grades a submission: renders with its fragments, and measures what comes out", "grade");
    std::string toolchain;
    app.add_option("--toolchain", toolchain, "what the build wrote about itself")->group("");
    app.set_version_flag("--version", fmt::format("grade {}", PENUMBRA_VERSION));

    GradeArguments grading;
    add_grade_options(app, grading);
    PictureArguments picture_arguments;
    CLI::App* picture = add_picture_command(app, picture_arguments);
    CallArguments call_arguments;
    CLI::App* call = add_call_command(app, call_arguments);
    TheoryArguments theory_arguments;
    CLI::App* theory = add_theory_command(app, theory_arguments);
    for (const Study& study : studies) app.add_subcommand(study.name, study.purpose)->prefix_command()->set_help_flag();
    HandOutArguments hand_out_arguments;
    CLI::App* starter = add_hand_out_command(app, hand_out_arguments);
    DescribeArguments describe_arguments;
    CLI::App* tables = add_describe_command(app, describe_arguments);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : usage;
    }
    const std::string command = command_of(argc, argv);
    return exit_code_of([&] {
        for (const Study& study : studies)
            if (app.got_subcommand(study.name)) return start_study(study, argv);
        if (toolchain.empty()) {
            toolchain = own_toolchain().string();
            tell_whose_assignment(toolchain);
        }
        if (tables->parsed()) return run_describe(describe_arguments, toolchain);
        if (starter->parsed()) return run_hand_out(hand_out_arguments, toolchain);
        if (picture->parsed()) return run_picture(picture_arguments, toolchain);
        if (call->parsed()) return run_call(call_arguments, toolchain);
        if (theory->parsed()) return run_theory(theory_arguments, toolchain);
        return run_grade(grading, toolchain, command);
    });
}

}  // namespace grade
