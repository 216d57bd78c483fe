#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "authoring/audit.h"
#include "programs/toolchain.h"
#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"
#include "studies/commands.h"
#include "studies/studies.h"

namespace grade::authoring {

namespace {

struct AuditArguments {
    std::vector<std::string> fragments;
};

/// What fragments lack to be handed out. Returns the exit code: 0; 1 where something lacks.
int run_audit(const AuditArguments& arguments, const Context& context) {
    const Toolchain chain = read_toolchain(context.toolchain);
    if (chain.is_kit)
        throw rt::InputError("a kit has no sources of the grader; expected the project that it comes from");
    const Assignment assignment = assignment_of(chain);
    const auto known = all_fragments(chain, assignment);
    for (const std::string& name : arguments.fragments)
        if (std::ranges::count(known, name) == 0) {
            const auto nearest = rt::nearest_word(name, known);
            throw rt::InputError(fmt::format("{}: no fragment has this name; expected {}", rt::in_quotes(name),
                                             nearest ? *nearest + "?" : "one that fragments.h declares"));
        }

    std::size_t lacks = 0;
    fmt::print("{:<22} {:>6} {:>10} {:>8} {:>5} {:>8} {:>6}\n", "fragment", "checks", "statistics", "mistakes", "right",
               "promises", "scenes");
    const auto all = audit(chain.source, assignment, arguments.fragments);
    for (const Audit& one : all) {
        fmt::print("{:<22} {:>6} {:>10} {:>8} {:>5} {:>8} {:>6}\n", one.fragment, one.checks, one.statistics, one.wrong,
                   one.right, one.promises, one.scenes.size());
        lacks += one.lacks.size();
    }
    for (const Audit& one : all)
        for (const std::string& line : one.lacks) fmt::print("{}\n", line);
    const std::string names = arguments.fragments.size() == 1 ? " " + arguments.fragments.front() : "";
    fmt::print(
        "{}. What texts do not tell: ./grade calibrate --fast{}, and tests/variants/mutants.py "
        "build/release/grader/grade{}\n",
        lacks == 0 ? "nothing lacks" : fmt::format("{} thing{} lacking", lacks, lacks == 1 ? "" : "s"), names, names);
    return lacks > 0 ? 1 : 0;
}

}  // namespace

Command audit_command(CLI::App& app) {
    const auto arguments = std::make_shared<AuditArguments>();
    CLI::App* command = app.add_subcommand("audit", purpose_of("audit"));
    command->add_option("FRAGMENT", arguments->fragments, "default: all of the assignment");
    command->fallthrough();
    return {command, [arguments](const Context& context) { return run_audit(*arguments, context); }};
}

}  // namespace grade::authoring
