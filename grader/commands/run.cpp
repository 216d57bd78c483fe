#include "commands/run.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <functional>

#include "files/interrupt.h"
#include "programs/toolchain.h"
#include "report/escape.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

/// Runs a command to its exit code; what it throws is told on stderr.
int exit_code_of(const std::function<int()>& command) {
    try {
        return command();
    } catch (const Interrupted&) {
        return stopped;
    } catch (const rt::InputError& error) {
        fmt::print(stderr, "{}\n", printable(error.what()));
        return usage;
    } catch (const std::exception& error) {
        fmt::print(stderr, "the grader failed: {}\n", printable(error.what()));
        return infrastructure;
    }
}

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

}  // namespace

int run_commands(CLI::App& app, const std::vector<Command>& commands, int argc, char** argv) {
    Context context{"", command_of(argc, argv)};
    app.add_option("--toolchain", context.toolchain, "what the build wrote about itself")->group("");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : usage;
    }
    return exit_code_of([&] {
        const auto named = std::ranges::find_if(commands, [](const Command& c) { return c.app->parsed(); });
        if (named == commands.end()) return int(usage);
        if (named->needs_compiler && context.toolchain.empty()) {
            context.toolchain = own_toolchain().string();
            tell_whose_assignment(context.toolchain);
        }
        return named->run(context);
    });
}

}  // namespace grade
