#include "commands/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "assignment/assignment.h"
#include "files/files.h"
#include "programs/toolchain.h"
#include "rt/files/scene_reader.h"
#include "theory/theory.h"

namespace grade {

namespace {

struct TheoryArguments {
    std::string submission, name;
    const CLI::Option* new_file = nullptr;  // --name
};

int write_new(const std::string& file, const std::string& name) {
    std::error_code error;
    if (fs::exists(file, error))
        throw rt::InputError(file + ":1:1: is there already; expected none, where a new one is to be written");
    write_text(file, empty_theory(name));
    fmt::print("{}: answer the questions there, then ./grade theory\n", file);
    return 0;
}

/// Checks a submission's theory.toml, or with a name writes a new one. Returns the exit code: 0; 1 where an answer is
/// wrong or missing.
int run_theory(const TheoryArguments& arguments, const Context& context) {
    const Toolchain chain = read_toolchain(context.toolchain);
    const Assignment assignment = assignment_of(chain);
    if (!assignment.theory_points)
        throw rt::InputError("this course has no theory part: its assignment.toml has no [theory] with points");
    const fs::path folder = arguments.submission.empty() ? chain.source / "starter" : fs::path(arguments.submission);
    const std::string file = (folder / "theory.toml").string();
    if (arguments.new_file->count() > 0) return write_new(file, arguments.name);
    const std::optional<std::string> text = read_text(file);
    if (!text)
        throw rt::InputError(file +
                             ":1:1: cannot be read; expected the file that ./grade theory --name \"Your Name\" writes");
    const Theory theory = read_theory(*text, file);
    fmt::print("{}", told(theory, *assignment.theory_points));
    return theory.right() == int(theory.answers.size()) ? 0 : 1;
}

}  // namespace

Command theory_command(CLI::App& app) {
    const auto arguments = std::make_shared<TheoryArguments>();
    CLI::App* theory = app.add_subcommand("theory", "check the answers of theory.toml, in the folder of a submission");
    theory->add_option("SUBMISSION", arguments->submission, "a folder; default: starter");
    arguments->new_file =
        theory->add_option("--name", arguments->name, "write a new theory.toml, with the questions for this name")
            ->type_name("NAME");
    return {theory, [arguments](const Context& context) { return run_theory(*arguments, context); }};
}

}  // namespace grade
