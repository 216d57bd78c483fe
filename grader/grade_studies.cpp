#include <CLI/CLI.hpp>
#include <functional>
#include <utility>
#include <vector>

#include "authoring/audit_command.h"
#include "authoring/new_command.h"
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

namespace {

/// Of all commands: the command line fills in those of the one that it names.
struct Arguments {
    std::string toolchain, command;
    stress::StressArguments stress;
    convergence::ConvergeArguments converge;
    lesson::LessonArguments lesson;
    calibration::CalibrateArguments calibrate;
    ConvertArguments convert;
    course::ClassArguments whole_class;
    course::MergeArguments merge;
    course::AgainArguments again;
    course::CompareArguments compare;
    authoring::NewArguments new_part;
    authoring::AuditArguments audit;

    /// That of this program, where none is named.
    const std::string& chain() {
        if (!toolchain.empty()) return toolchain;
        toolchain = own_toolchain().string();
        tell_whose_assignment(toolchain);
        return toolchain;
    }
};

using Commands = std::vector<std::pair<CLI::App*, std::function<int()>>>;

Commands add_commands(CLI::App& app, Arguments& a) {
    return {
        {stress::add_stress_command(app, a.stress), [&] { return stress::run_stress(a.stress, a.chain(), a.command); }},
        {convergence::add_converge_command(app, a.converge),
         [&] { return convergence::converge(a.converge, a.chain(), a.command); }},
        {lesson::add_lesson_command(app, a.lesson), [&] { return lesson::run_lesson(a.lesson, a.chain()), 0; }},
        {calibration::add_calibrate_command(app, a.calibrate),
         [&] { return calibration::calibrate(a.calibrate, a.chain(), a.command) ? 0 : int(below_required); }},
        // what only reads records needs no compiler
        {add_convert_command(app, a.convert), [&] { return run_convert(a.convert), 0; }},
        {course::add_merge_command(app, a.merge), [&] { return course::run_merge(a.merge); }},
        {course::add_compare_command(app, a.compare), [&] { return course::run_compare(a.compare); }},
        {course::add_class_command(app, a.whole_class), [&] { return course::run_class(a.whole_class, a.chain()); }},
        {course::add_replay_command(app, a.again), [&] { return course::run_replay(a.again, a.chain(), a.command); }},
        {course::add_verify_command(app, a.again), [&] { return course::run_verify(a.again, a.chain(), a.command); }},
        {authoring::add_new_command(app, a.new_part), [&] { return authoring::run_new(a.new_part, a.chain()), 0; }},
        {authoring::add_audit_command(app, a.audit), [&] { return authoring::run_audit(a.audit, a.chain()); }},
    };
}

}  // namespace

/// The command line of the studies: studies/studies.h.
int main(int argc, char** argv) {
    rt::require_processor();
    CLI::App app("Studies of a submission, and of the grader", "grade");
    Arguments arguments;
    app.add_option("--toolchain", arguments.toolchain, "what the build wrote about itself")->group("");
    app.require_subcommand(1);
    const Commands commands = add_commands(app, arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : usage;
    }
    arguments.command = command_of(argc, argv);
    return exit_code_of([&] {
        for (const auto& [command, run] : commands)
            if (command->parsed()) return run();
        return int(usage);
    });
}
