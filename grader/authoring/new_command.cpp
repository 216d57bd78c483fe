#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "authoring/new.h"
#include "files/files.h"
#include "programs/process.h"
#include "programs/toolchain.h"
#include "rt/files/scene_reader.h"
#include "studies/commands.h"
#include "studies/numbers.h"
#include "studies/studies.h"

namespace grade::authoring {

namespace {

struct NewArguments {
    NewFragment fragment;
    NewVariant variant;
    std::string scene, scene_like, check, check_of;
    std::vector<CLI::App*> kinds;  // fragment, scene, check, mistake
};

CLI::App* add_fragment(CLI::App& app, NewFragment& fragment) {
    CLI::App* command = app.add_subcommand("fragment", "its declaration, points, solution, blank, checks and section");
    command->add_option("NAME", fragment.name, "as students will call it")->required();
    command->add_option("--like", fragment.like, "takes the signature, the comment and the place of this one")
        ->type_name("OTHER");
    command->add_option("--declare", fragment.declaration, "another signature: 'DiskSample ring(Real inner, vec2 u)'")
        ->type_name("CODE");
    command->add_option("--part", fragment.part, "where it comes last; default: after OTHER, else the last part");
    command->add_option("--points", fragment.points, "of 100 or so")
        ->capture_default_str()
        ->check(in_range(0, most_points));
    return command;
}

CLI::App* add_mistake(CLI::App& app, NewVariant& variant) {
    CLI::App* command =
        app.add_subcommand("mistake", "a patch of a solution in tests/variants, by which checks are judged");
    command->add_option("NAME", variant.name, "in a few words")->required();
    command->add_option("--of", variant.fragment, "whose solution is changed")->required()->type_name("FRAGMENT");
    command->add_option("--old", variant.old_text, "text of the solution, which is there once")->required();
    command->add_option("--new", variant.new_text, "what a student writes in its place")->required();
    command->add_option("--what", variant.what, "the mistake in words");
    command->add_option("--says", variant.says, "words of which the hint must hold one")->type_name("WORD|WORD");
    command->add_flag("--right", variant.right, "it is no mistake, but another right way");
    return command;
}

void tell_next(const NewArguments& arguments) {
    if (arguments.kinds[0]->parsed())
        fmt::print(
            "Next: write what FILL IN stands for; ./grade describe --update handout.md makes the table; "
            "./grade audit {} says what it lacks\n",
            arguments.fragment.name);
    else if (arguments.kinds[1]->parsed())
        fmt::print("Next: write what FILL IN stands for; ./grade picture scenes/{}.toml shows it\n", arguments.scene);
    else if (arguments.kinds[2]->parsed())
        fmt::print("Next: write what FILL IN stands for; ./grade solution {} runs it\n", arguments.check_of);
    else
        fmt::print("Next: ./grade calibrate --fast {} grades it\n", arguments.variant.name);
}

/// As .clang-format has it, by the version that the test of the format asks for.
void format(const fs::path& project, const Files& files) {
    std::vector<std::string> command{"/usr/bin/clang-format", "-i"}, names;
    for (const auto& [file, text] : files)
        if (file.extension() == ".cpp") names.push_back(file.string()), command.push_back((project / file).string());
    if (names.empty()) return;
    if (run({command[0], "--version"}, {}, "/").out.find(" version 14.") == std::string::npos)
        fmt::print("There is no clang-format 14 here; before ./check: clang-format -i {}\n", fmt::join(names, " "));
    else if (const Ending ending = run(command, {}, "/"); !ending.good())
        throw std::runtime_error("clang-format: " + ending.err);
}

/// The files of a new part of the assignment, where FILL IN says what is to be written.
int run_new(const NewArguments& arguments, const Context& context) {
    const Toolchain chain = read_toolchain(context.toolchain);
    if (chain.is_kit)
        throw rt::InputError("a kit has no sources of the grader; expected the project that it comes from");
    const fs::path& project = chain.source;
    const auto files = [&] {
        if (arguments.kinds[0]->parsed()) return new_fragment(project, assignment_of(chain), arguments.fragment);
        if (arguments.kinds[1]->parsed()) return new_scene(project, arguments.scene, arguments.scene_like);
        if (arguments.kinds[2]->parsed()) return new_check(project, arguments.check, arguments.check_of);
        return new_variant(project, arguments.variant);
    }();
    for (const auto& [file, text] : files) {
        const bool is_new = !fs::exists(project / file);
        write_text(project / file, text);
        fmt::print("{} {}\n", is_new ? "made   " : "changed", file.string());
    }
    format(project, files);
    tell_next(arguments);
    return 0;
}

}  // namespace

Command new_command(CLI::App& app) {
    const auto arguments = std::make_shared<NewArguments>();
    CLI::App* command = app.add_subcommand("new", purpose_of("new"));
    command->require_subcommand(1);
    CLI::App* scene = command->add_subcommand("scene", "a file in scenes/");
    scene->add_option("NAME", arguments->scene, "of the file, without .toml")->required();
    scene->add_option("--like", arguments->scene_like, "what it begins as")->type_name("OTHER");
    CLI::App* check = command->add_subcommand("check", "one more in the file of a fragment");
    check->add_option("NAME", arguments->check, "as reports call it")->required();
    check->add_option("--of", arguments->check_of, "whose points it decides")->required()->type_name("FRAGMENT");
    arguments->kinds = {add_fragment(*command, arguments->fragment), scene, check,
                        add_mistake(*command, arguments->variant)};
    command->fallthrough();
    return {command, [arguments](const Context& context) { return run_new(*arguments, context); }};
}

}  // namespace grade::authoring
