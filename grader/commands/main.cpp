#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "build/files.h"
#include "build/hand_out.h"
#include "build/interrupt.h"
#include "build/submission.h"
#include "calibration/command.h"
#include "commands/grading.h"
#include "commands/picture.h"
#include "commands/words.h"
#include "convergence/command.h"
#include "lesson/command.h"
#include "report/describe.h"
#include "rt/files/scene_reader.h"
#include "rt/processor.h"
#include "stress/command.h"

/// grade SUBMISSION: the command line. Each subcommand is a function that returns the exit code.
namespace {

using namespace grade;

enum ExitCode { graded = 0, below_required = 1, usage = 2, infrastructure = 3, stopped = 130 };

/// The command as it can be typed again.
std::string command_of(int argc, char** argv) {
    std::string command = "grade";
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool plain =
            !word.empty() && word.find_first_not_of(
                                 "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+") == word.npos;
        std::string quoted = "'";
        for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
        command += " " + (plain ? word : quoted + "'");
    }
    return command;
}

int describe(const std::string& handout, const std::string& toolchain) {
    const Assignment assignment = read_assignment((read_toolchain(toolchain).source / "assignment.toml").string());
    if (handout.empty()) {
        fmt::print("{}\n", describe_points(assignment));
        for (const Fragment& fragment : assignment.fragments)
            fmt::print("### {}\n\n{}\n", fragment.name, describe_checks(assignment, fragment.name));
        return graded;
    }
    const auto text = read_text(handout);
    if (!text) throw UsageError(fmt::format("--update {}: cannot be read; expected the handout", handout));
    write_text(handout, with_new_tables(*text, assignment, handout));
    return graded;
}

int run_hand_out(const std::string& folder, const std::vector<std::string>& others, const std::string& toolchain) {
    const Toolchain chain = read_toolchain(toolchain);
    if (chain.is_kit) throw UsageError("a kit is handed out by the project that it comes from: it has no sources of the solution");
    const Assignment assignment = read_assignment((chain.source / "assignment.toml").string());
    hand_out(chain.source, assignment, fs::path(toolchain).parent_path() / "kit.toml", folder, {others.begin(), others.end()});
    fmt::print("{}\n", folder);
    return graded;
}

}  // namespace

int main(int argc, char** argv) {
    rt::require_processor();
    CLI::App app("Grades a submission: renders with its fragments, and measures what comes out", "grade");
    std::string toolchain, handout, folder;
    std::vector<std::string> others;
    app.add_option("--toolchain", toolchain, "what the build wrote about itself")->group("");
    app.set_version_flag("--version", fmt::format("grade {}", PENUMBRA_VERSION));

    GradeArguments grading;
    add_grade_options(app, grading);
    PictureArguments picture_arguments;
    CLI::App* picture = add_picture_command(app, picture_arguments);
    StressArguments stress_arguments;
    CLI::App* stress = add_stress_command(app, stress_arguments);
    ConvergeArguments converge_arguments;
    CLI::App* convergence = add_converge_command(app, converge_arguments);
    LessonArguments lesson_arguments;
    CLI::App* part_one = add_lesson_command(app, lesson_arguments);
    CalibrateArguments calibration;
    CLI::App* trust = add_calibrate_command(app, calibration);
    CLI::App* starter = app.add_subcommand("hand-out", "write what students get into a new folder: a kit");
    starter->add_option("FOLDER", folder, "is not there yet, or empty")->required();
    starter->add_option("--add", others, "another hand-out, made on another kind of processor, whose grader comes along")
        ->type_name("KIT");
    CLI::App* tables = app.add_subcommand("describe", "print the handout's tables of points and checks");
    tables->add_option("--update", handout, "make them anew in this file")->type_name("FILE");

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : usage;
    }
    const std::string command = command_of(argc, argv);
    try {
        if (toolchain.empty()) toolchain = own_toolchain().string();
        if (trust->parsed()) return calibrate(calibration, toolchain, command) ? graded : below_required;
        if (tables->parsed()) return describe(handout, toolchain);
        if (starter->parsed()) return run_hand_out(folder, others, toolchain);
        if (picture->parsed()) return run_picture(picture_arguments, toolchain);
        if (convergence->parsed()) return converge(converge_arguments, toolchain, command);
        if (part_one->parsed()) return lesson(lesson_arguments, toolchain), graded;
        if (stress->parsed()) return run_stress(stress_arguments, toolchain, command);
        return run_grade(grading, toolchain, command);
    } catch (const Interrupted&) {
        return stopped;
    } catch (const UsageError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return usage;
    } catch (const std::invalid_argument& error) {
        fmt::print(stderr, "{}\n", error.what());
        return usage;
    } catch (const SubmissionError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return usage;
    } catch (const rt::InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return usage;
    } catch (const std::exception& error) {
        fmt::print(stderr, "the grader failed: {}\n", error.what());
        return infrastructure;
    }
}
