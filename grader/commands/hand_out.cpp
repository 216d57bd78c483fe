#include "hand_out/hand_out.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands/commands.h"
#include "commands/run.h"
#include "commands/words.h"
#include "files/files.h"
#include "hand_out/gradescope.h"
#include "judging/grading.h"
#include "rt/files/scene_reader.h"
#include "studies/numbers.h"

namespace grade {

namespace {

struct HandOutArguments {
    std::string folder, gradescope;
    std::vector<std::string> others;
    std::optional<std::uint64_t> seed;
    bool installed = false;
};

/// Makes a kit. Returns the exit code.
int run_hand_out(const HandOutArguments& arguments, const Context& context) {
    require_file(arguments.gradescope, "--gradescope");
    const Toolchain chain = read_toolchain(context.toolchain);
    if (chain.is_kit)
        throw rt::InputError(
            "a kit is handed out by the project that it comes from: it has no sources of the solution");
    const Assignment assignment = assignment_of(chain);
    hand_out(chain.source, assignment, fs::path(context.toolchain).parent_path() / "kit.toml", arguments.folder,
             {arguments.others.begin(), arguments.others.end()}, arguments.installed ? For::everybody : For::students);
    fmt::print("{}\n", arguments.folder);
    if (!fs::exists(fs::path(arguments.folder) / "handout.html"))
        fmt::print("without a page of the handout, which pandoc makes: students read handout.md\n");
    if (!arguments.gradescope.empty()) {
        write_gradescope(chain.source, arguments.folder, arguments.seed ? *arguments.seed : fresh_seed(),
                         arguments.gradescope);
        fmt::print("{}\n", arguments.gradescope);
    }
    return graded;
}

}  // namespace

Command hand_out_command(CLI::App& app) {
    const auto arguments = std::make_shared<HandOutArguments>();
    CLI::App* command = app.add_subcommand("hand-out", "write what students get into a new folder: a kit");
    command->add_option("FOLDER", arguments->folder, "is not there yet, or empty")->required();
    command
        ->add_option("--add", arguments->others,
                     "another hand-out, made on another kind of processor, whose grader comes along")
        ->type_name("KIT");
    CLI::Option* zip =
        command->add_option("--gradescope", arguments->gradescope, "and the autograder that Gradescope takes")
            ->type_name("ZIP");
    command->add_option("--seed", arguments->seed, "of all gradings there; default: a fresh one")
        ->type_name("N")
        ->check(is_seed())
        ->needs(zip);
    command->add_flag("--installed", arguments->installed, "what cmake --install puts below /usr")->group("");
    return {command, [arguments](const Context& context) { return run_hand_out(*arguments, context); }};
}

}  // namespace grade
