#include "commands/commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "commands/run.h"
#include "files/files.h"
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

Command study_command(CLI::App& app, const Study& study, char** argv) {
    CLI::App* command = app.add_subcommand(study.name, study.purpose)->prefix_command();
    command->set_help_flag();
    return {command, [&study, argv](const Context&) { return start_study(study, argv); }, false};
}

}  // namespace

int run_command_line(int argc, char** argv) {
    CLI::App app("Grades a submission: renders with its fragments, and measures what comes out", "grade");
    app.set_version_flag("--version", fmt::format("grade {}", PENUMBRA_VERSION));
    app.require_subcommand(0, 1);  // what follows are its arguments, also where a folder has the name of a command
    std::vector<Command> commands{picture_command(app), call_command(app), theory_command(app)};
    for (const Study& study : studies) commands.push_back(study_command(app, study, argv));
    commands.push_back(hand_out_command(app));
    commands.push_back(describe_command(app));
    commands.push_back(grade_command(app));  // where there is no other word
    return run_commands(app, commands, argc, argv);
}

}  // namespace grade
