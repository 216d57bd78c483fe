#include <CLI/CLI.hpp>

#include "calibration/command.h"
#include "class/again_command.h"
#include "class/command.h"
#include "commands/exit_code.h"
#include "convergence/command.h"
#include "convert/command.h"
#include "lesson/command.h"
#include "programs/toolchain.h"
#include "rt/processor.h"
#include "stress/command.h"

using namespace grade;

/// The command line of the studies: studies/studies.h.
int main(int argc, char** argv) {
    rt::require_processor();
    CLI::App app("Studies of a submission, and of the grader", "grade");
    std::string toolchain;
    app.add_option("--toolchain", toolchain, "what the build wrote about itself")->group("");
    app.require_subcommand(1);

    stress::StressArguments stress_arguments;
    CLI::App* extremes = stress::add_stress_command(app, stress_arguments);
    convergence::ConvergeArguments converge_arguments;
    CLI::App* errors = convergence::add_converge_command(app, converge_arguments);
    lesson::LessonArguments lesson_arguments;
    CLI::App* part_one = lesson::add_lesson_command(app, lesson_arguments);
    calibration::CalibrateArguments calibrate_arguments;
    calibration::add_calibrate_command(app, calibrate_arguments);

    ConvertArguments convert_arguments;
    CLI::App* convert = add_convert_command(app, convert_arguments);
    course::ClassArguments class_arguments;
    CLI::App* whole_class = course::add_class_command(app, class_arguments);
    course::MergeArguments merge_arguments;
    CLI::App* merge = course::add_merge_command(app, merge_arguments);
    course::AgainArguments again_arguments;
    CLI::App* replay = course::add_replay_command(app, again_arguments);
    CLI::App* verify = course::add_verify_command(app, again_arguments);
    course::CompareArguments compare_arguments;
    course::add_compare_command(app, compare_arguments);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : usage;
    }
    const std::string command = command_of(argc, argv);
    return exit_code_of([&] {
        // what only reads records needs no compiler
        if (convert->parsed()) return run_convert(convert_arguments), int(graded);
        if (merge->parsed()) return course::run_merge(merge_arguments);
        if (app.got_subcommand("compare")) return course::run_compare(compare_arguments);
        if (toolchain.empty()) toolchain = own_toolchain().string();
        if (whole_class->parsed()) return course::run_class(class_arguments, toolchain);
        if (replay->parsed()) return course::run_replay(again_arguments, toolchain, command);
        if (verify->parsed()) return course::run_verify(again_arguments, toolchain, command);
        if (extremes->parsed()) return stress::run_stress(stress_arguments, toolchain, command);
        if (errors->parsed()) return convergence::converge(converge_arguments, toolchain, command);
        if (part_one->parsed()) return lesson::run_lesson(lesson_arguments, toolchain), 0;
        return calibration::calibrate(calibrate_arguments, toolchain, command) ? 0 : int(below_required);
    });
}
