#include <CLI/CLI.hpp>

#include "commands/run.h"
#include "rt/processor.h"
#include "studies/commands.h"

/// The command line of the studies: studies/studies.h.
int main(int argc, char** argv) {
    using namespace grade;
    rt::require_processor();
    CLI::App app("Studies of a submission, and of the grader", "grade");
    app.require_subcommand(1);
    return run_commands(app,
                        {stress::stress_command(app), convergence::converge_command(app), lesson::lesson_command(app),
                         calibration::calibrate_command(app), convert_command(app), course::merge_command(app),
                         course::compare_command(app), course::class_command(app), course::replay_command(app),
                         course::verify_command(app), authoring::new_command(app), authoring::audit_command(app)},
                        argc, argv);
}
