#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>

#include "assignment.h"
#include "build/files.h"
#include "build/hand_out.h"
#include "build/submission.h"
#include "build/toolchain.h"
#include "calibration/command.h"
#include "checks/kit/check.h"
#include "convergence/command.h"
#include "judging/grading.h"
#include "judging/judge_check.h"
#include "lesson/command.h"
#include "report/describe.h"
#include "report/page.h"
#include "report/terminal.h"
#include "rt/files/scene_reader.h"
#include "stress/command.h"

/// grade SUBMISSION: the command line. Each subcommand is a function that returns the exit code.
namespace {

using namespace grade;

enum ExitCode { graded = 0, below_required = 1, usage = 2, infrastructure = 3 };

/// What is wrong with a command line beyond what its parser sees.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Arguments {
    std::string submission, mode, json, html, keep, toolchain = GRADE_TOOLCHAIN, own_scene, handout, folder;
    std::vector<std::string> only;
    std::optional<std::uint64_t> seed;
    std::optional<double> required;
    int jobs = 0, replicates = 64;
    double time_limit = 10;
    bool trusted = false, fresh = false;
};

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

std::uint64_t fresh_seed() {
    std::random_device device;
    return device() % 1'000'000 + 1;
}

GradingSettings settings_of(const Arguments& arguments, const Assignment& assignment, const Toolchain& chain) {
    GradingSettings settings;
    for (const std::string& name : arguments.only) {
        const auto names = assignment.names();
        if (std::ranges::count(names, name) == 0)
            throw UsageError(fmt::format("--only {}: no fragment has this name; assignment.toml lists them", name));
        settings.only.insert(name);
    }
    settings.student = arguments.mode.empty() ? !chain.has_solution() : arguments.mode == "student";
    if (!settings.student && !chain.has_solution())
        throw UsageError("--mode instructor needs the folder solution/, which is not here");
    if (settings.student && arguments.seed && *arguments.seed != student_seed)
        throw UsageError(fmt::format(
            "--seed {}: in student mode the seed is {}, which the stored statistics of the solution belong to",
            *arguments.seed, student_seed));
    settings.seed = settings.student ? student_seed : arguments.seed ? *arguments.seed : fresh_seed();
    settings.jobs = arguments.jobs;
    settings.time_limit = arguments.time_limit;
    settings.trusted = arguments.trusted;
    settings.keep = arguments.keep;
    settings.pictures = !arguments.html.empty();
    // The seed of student mode is always the same: what has not changed comes out as it did.
    if (settings.student && !arguments.fresh && arguments.keep.empty())
        settings.kept = Kept(fs::path(arguments.toolchain).parent_path() / "kept", chain);
    const fs::path folder = fs::path(arguments.json).parent_path();
    if (!folder.empty() && !fs::is_directory(folder))
        throw UsageError(fmt::format("--json {}: there is no folder {}", arguments.json, folder.string()));
    const fs::path gallery = chain.source / "scenes/gallery/everything.toml";
    if (!arguments.own_scene.empty())
        rt::read_scene(arguments.own_scene);  // says what is wrong with it, before all the work
    if (settings.pictures)
        settings.own_scene = !arguments.own_scene.empty() ? fs::path(arguments.own_scene)
                             : fs::exists(gallery)        ? gallery
                                                          : fs::path();
    return settings;
}

int grade_one(Arguments arguments, std::string command) {
    const Toolchain chain = read_toolchain(arguments.toolchain);
    if (arguments.submission.empty()) arguments.submission = (chain.source / "starter").string();
    // Whoever edits the starter always gets the pictures as well.
    std::error_code missing;
    if (arguments.html.empty() && arguments.only.empty() &&
        fs::equivalent(arguments.submission, chain.source / "starter", missing))
        arguments.html = (fs::path(arguments.toolchain).parent_path() / "report").string();
    const Assignment assignment = read_assignment((chain.source / "assignment.toml").string());
    GradingSettings settings = settings_of(arguments, assignment, chain);
    const Submission submission = read_submission(arguments.submission, assignment.names());
    const std::vector<Check> checks = all_checks(settings.seed);

    if (!arguments.seed && !settings.student) command += fmt::format(" --seed {}", settings.seed);
    ProgressLine line;
    settings.progress = [&](int done, int all, const std::string& doing) { line.show(done, all, doing); };
    if (!arguments.json.empty())
        settings.partial = [&](Record record) {
            record.command = command;
            write_text(arguments.json, to_json(record));
        };
    Record record = grade_submission(submission, assignment, chain, checks, settings);
    record.command = command;
    line.clear();

    if (!arguments.json.empty()) write_text(arguments.json, to_json(record));
    if (!arguments.html.empty()) {
        fs::create_directories(arguments.html);
        const fs::path handout = fs::relative(chain.source / "handout.md", arguments.html);
        write_text(fs::path(arguments.html) / "index.html", page(record, assignment, handout.generic_string()));
    }
    fmt::print("{}\nseed {}, {} mode; {}\n", table(record, assignment, isatty(STDOUT_FILENO)), record.seed,
               record.student_mode ? "student" : "instructor", record.sandbox);
    if (record.reused > 0)
        fmt::print("{} checks as before: nothing that they depend on has changed (--fresh runs them again)\n",
                   record.reused);
    if (!arguments.html.empty()) fmt::print("page: {}\n", (fs::path(arguments.html) / "index.html").string());
    return arguments.required && record.score() < *arguments.required ? below_required : graded;
}

int store_references(const Arguments& arguments) {
    const Toolchain chain = read_toolchain(arguments.toolchain);
    if (!chain.has_solution()) throw UsageError("references are made from the folder solution/, which is not here");
    const std::vector<Check> checks = all_checks(student_seed);
    ProgressLine line;
    const auto stored =
        make_references(chain, checks, arguments.replicates, arguments.jobs,
                        [&](int done, int all, const std::string& doing) { line.show(done, all, doing); });
    line.clear();
    const fs::path folder = chain.source / "scenes/reference";
    write_references(folder, checks, stored, student_seed);
    fmt::print("{} checks in {}\n", stored.size(), folder.string());
    return graded;
}

int describe(const Arguments& arguments) {
    const Assignment assignment =
        read_assignment((read_toolchain(arguments.toolchain).source / "assignment.toml").string());
    if (arguments.handout.empty()) {
        fmt::print("{}\n", describe_points(assignment));
        for (const Fragment& fragment : assignment.fragments)
            fmt::print("### {}\n\n{}\n", fragment.name, describe_checks(assignment, fragment.name));
        return graded;
    }
    const auto text = read_text(arguments.handout);
    if (!text) throw UsageError(fmt::format("--update {}: cannot be read; expected the handout", arguments.handout));
    write_text(arguments.handout, with_new_tables(*text, assignment, arguments.handout));
    return graded;
}

int hand_out_starter(const Arguments& arguments) {
    const Toolchain chain = read_toolchain(arguments.toolchain);
    if (!chain.has_solution()) throw UsageError("the blanks are made from the folder solution/, which is not here");
    hand_out(chain.source, read_assignment((chain.source / "assignment.toml").string()), arguments.folder);
    fmt::print("{}\n", arguments.folder);
    return graded;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Grades a submission: renders with its fragments, and measures what comes out", "grade");
    Arguments arguments;
    app.add_option("SUBMISSION", arguments.submission, "a folder, a .zip or a .tar.gz; default: starter");
    app.add_option("--only", arguments.only, "grade only these fragments")->delimiter(',')->type_name("FRAGMENT");
    app.add_option("--seed", arguments.seed, "of all parameters and random numbers; default: a fresh one")
        ->type_name("N");
    app.add_option("--mode", arguments.mode,
                   "instructor: each fragment with the solution's others; student: with the submission's own")
        ->check(CLI::IsMember({"instructor", "student"}));
    app.add_option("--json", arguments.json, "write the record of the grading")->type_name("FILE");
    app.add_option("--html", arguments.html,
                   "write a page with all pictures into this folder; a whole starter always gets one")
        ->type_name("DIR");
    app.add_option("--require", arguments.required, "exit with 1 below so many points")->type_name("POINTS");
    app.add_option("--jobs", arguments.jobs, "how many programs run at a time; default: one for each core")
        ->check(CLI::Range(1, 1024));
    app.add_option("--time-limit", arguments.time_limit, "CPU seconds for one answer of a fragment")
        ->capture_default_str()
        ->check(CLI::Range(1.0, 600.0));
    app.add_option("--keep", arguments.keep, "leave objects and programs in this folder")->type_name("DIR");
    app.add_option("--picture", arguments.own_scene, "the scene of the submission's own picture on the page")
        ->type_name("SCENE");
    app.add_flag("--fresh", arguments.fresh, "run all checks again, also those that nothing has changed for");
    app.add_flag("--trusted", arguments.trusted, "the code is your own: limits, but no sandbox");
    app.add_option("--toolchain", arguments.toolchain, "what the build wrote about itself")->group("");

    CLI::App* references =
        app.add_subcommand("references", "store the solution's statistics for students, who have no solution");
    references->add_option("--replicates", arguments.replicates, "of each check")
        ->capture_default_str()
        ->check(CLI::Range(8, 100000));
    references->add_option("--jobs", arguments.jobs, "how many programs run at a time")->check(CLI::Range(1, 1024));
    references->fallthrough();

    CLI::App* starter = app.add_subcommand("hand-out", "write what students get into a new folder");
    starter->add_option("FOLDER", arguments.folder, "is not there yet, or empty")->required();
    starter->fallthrough();

    CalibrateArguments calibration;
    CLI::App* trust = add_calibrate_command(app, calibration);

    ConvergeArguments converge_arguments;
    CLI::App* convergence = add_converge_command(app, converge_arguments);

    LessonArguments lesson_arguments;
    CLI::App* part_one = add_lesson_command(app, lesson_arguments);

    StressArguments stress_arguments;
    CLI::App* stress = add_stress_command(app, stress_arguments);

    CLI::App* tables = app.add_subcommand("describe", "print the handout's tables of points and checks");
    tables->add_option("--update", arguments.handout, "make them anew in this file")->type_name("FILE");
    tables->fallthrough();

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : usage;
    }
    try {
        if (references->parsed()) return store_references(arguments);
        if (trust->parsed())
            return calibrate(calibration, arguments.toolchain, command_of(argc, argv)) ? graded : below_required;
        if (tables->parsed()) return describe(arguments);
        if (starter->parsed()) return hand_out_starter(arguments);
        if (convergence->parsed())
            return converge(converge_arguments, arguments.toolchain, command_of(argc, argv));
        if (part_one->parsed()) return lesson(lesson_arguments, arguments.toolchain), graded;
        if (stress->parsed()) return run_stress(stress_arguments, command_of(argc, argv));
        return grade_one(arguments, command_of(argc, argv));
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
