#include "report/describe.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands/commands.h"
#include "commands/run.h"
#include "files/files.h"
#include "programs/toolchain.h"
#include "report/scene_tables.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

struct DescribeArguments {
    std::string handout, students;
};

/// Tables of points, of checks, and of the keys of scenes. Returns the exit code.
int run_describe(const DescribeArguments& arguments, const Context& context) {
    const auto& [handout, students] = arguments;
    const Toolchain chain = read_toolchain(context.toolchain);
    const Assignment assignment = assignment_of(chain);
    if (!students.empty()) {
        const std::string own = (chain.source / "handout.md").string();
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

}  // namespace

Command describe_command(CLI::App& app) {
    const auto arguments = std::make_shared<DescribeArguments>();
    CLI::App* command = app.add_subcommand("describe", "print the handout's tables of points and checks");
    command->add_option("--update", arguments->handout, "make them anew in this file: a handout, or a schema of scenes")
        ->type_name("FILE");
    command->add_option("--handed-out", arguments->students, "write the handout as a kit has it")->type_name("FILE");
    return {command, [arguments](const Context& context) { return run_describe(*arguments, context); }};
}

}  // namespace grade
