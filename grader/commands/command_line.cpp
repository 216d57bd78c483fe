#include "commands/commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <random>

#include "commands/exit_code.h"
#include "commands/words.h"
#include "files/files.h"
#include "hand_out/gradescope.h"
#include "hand_out/hand_out.h"
#include "report/describe.h"
#include "report/scene_tables.h"
#include "rt/files/scene_reader.h"
#include "studies/studies.h"

namespace grade {

namespace {

int describe(const std::string& handout, const std::string& students, const std::string& toolchain) {
    const fs::path source = read_toolchain(toolchain).source;
    const Assignment assignment = read_assignment((source / "assignment.toml").string());
    if (!students.empty()) {
        const std::string own = (source / "handout.md").string();
        write_text(students, handed_out(read_text(own).value_or(""), assignment, own));
        return graded;
    }
    if (fs::path(handout).extension() == ".json") {
        write_text(handout, scene_schema());
        return graded;
    }
    if (handout.empty()) {
        fmt::print("{}\n", describe_points(assignment));
        for (const Fragment& fragment : assignment.fragments)
            fmt::print("### {}\n\n{}\n", fragment.name, describe_checks(assignment, fragment.name));
        return graded;
    }
    const auto text = read_text(handout);
    if (!text) throw rt::InputError(fmt::format("--update {}: cannot be read; expected the handout", handout));
    write_text(handout, with_new_tables(*text, assignment, handout));
    return graded;
}

struct HandOutArguments {
    std::string folder, gradescope;
    std::vector<std::string> others;
    std::optional<std::uint64_t> seed;
    bool installed = false;
};

CLI::App* add_hand_out_command(CLI::App& app, HandOutArguments& arguments) {
    CLI::App* command = app.add_subcommand("hand-out", "write what students get into a new folder: a kit");
    command->add_option("FOLDER", arguments.folder, "is not there yet, or empty")->required();
    command
        ->add_option("--add", arguments.others,
                     "another hand-out, made on another kind of processor, whose grader comes along")
        ->type_name("KIT");
    CLI::Option* zip =
        command->add_option("--gradescope", arguments.gradescope, "and the autograder that Gradescope takes")
            ->type_name("ZIP");
    command->add_option("--seed", arguments.seed, "of all gradings there; default: a fresh one")
        ->type_name("N")
        ->needs(zip);
    command->add_flag("--installed", arguments.installed, "what cmake --install puts below /usr")->group("");
    return command;
}

int run_hand_out(const HandOutArguments& arguments, const std::string& toolchain) {
    require_folder_of(arguments.gradescope, "--gradescope");
    const Toolchain chain = read_toolchain(toolchain);
    if (chain.is_kit)
        throw rt::InputError(
            "a kit is handed out by the project that it comes from: it has no sources of the solution");
    const Assignment assignment = read_assignment((chain.source / "assignment.toml").string());
    hand_out(chain.source, assignment, fs::path(toolchain).parent_path() / "kit.toml", arguments.folder,
             {arguments.others.begin(), arguments.others.end()}, arguments.installed ? For::everybody : For::students);
    fmt::print("{}\n", arguments.folder);
    if (!fs::exists(fs::path(arguments.folder) / "handout.html"))
        fmt::print("without a page of the handout, which pandoc makes: students read handout.md\n");
    if (!arguments.gradescope.empty()) {
        std::random_device device;
        write_gradescope(chain.source, arguments.folder, arguments.seed ? *arguments.seed : device() % 1'000'000 + 1,
                         arguments.gradescope);
        fmt::print("{}\n", arguments.gradescope);
    }
    return graded;
}

/// Becomes the second program, with the same words. Returns the exit code where that is not there: 3.
int start_study(const Study& study, char** argv) {
    std::error_code error;
    const std::string program = fs::read_symlink("/proc/self/exe", error).string() + "_studies";
    execv(program.c_str(), argv);
    if (fs::exists(program, error))
        fmt::print(stderr, "{}: cannot be started; grade {} is in it\n", program, study.name);
    else
        fmt::print(
            stderr,
            "grade {0} is in a program of its own, {1}, which is not built yet: ./grade {0} builds it, and so does "
            "cmake --build --preset release --target grade_studies\n",
            study.name, program);
    return infrastructure;
}

}  // namespace

int run_command_line(int argc, char** argv) {
    CLI::App app("Grades a submission: renders with its fragments, and measures what comes out", "grade");
    std::string toolchain, handout, students;
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
    CLI::App* tables = app.add_subcommand("describe", "print the handout's tables of points and checks");
    tables->add_option("--update", handout, "make them anew in this file: a handout, or a schema of scenes")
        ->type_name("FILE");
    tables->add_option("--handed-out", students, "write the handout as a kit has it")->type_name("FILE");

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
        if (tables->parsed()) return describe(handout, students, toolchain);
        if (starter->parsed()) return run_hand_out(hand_out_arguments, toolchain);
        if (picture->parsed()) return run_picture(picture_arguments, toolchain);
        if (call->parsed()) return run_call(call_arguments, toolchain);
        if (theory->parsed()) return run_theory(theory_arguments, toolchain);
        return run_grade(grading, toolchain, command);
    });
}

}  // namespace grade
