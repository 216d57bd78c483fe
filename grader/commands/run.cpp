#include "commands/run.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <system_error>

#include "files/interrupt.h"
#include "programs/toolchain.h"
#include "report/escape.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

/// Where stderr is closed as well, nobody is told.
void tell(const std::string& words) { std::fputs((printable(words) + "\n").c_str(), stderr); }

/// Runs a command to its exit code; what it throws is told on stderr.
int exit_code_of(const std::function<int()>& command) {
    try {
        return command();
    } catch (const Interrupted&) {
        return stopped;
    } catch (const rt::InputError& error) {
        tell(error.what());
        return usage;
    } catch (const std::system_error& error) {
        // who reads the output wants no more of it: head has its lines
        if (error.code() == std::errc::broken_pipe) return unread;
        tell("the grader failed: " + std::string(error.what()));
        return infrastructure;
    } catch (const std::exception& error) {
        tell("the grader failed: " + std::string(error.what()));
        return infrastructure;
    }
}

/// The command as it can be typed again.
std::string command_of(int argc, char** argv) {
    std::string command = "grade";
    for (int i = 1; i < argc; ++i) command += " " + as_typed(argv[i]);
    return command;
}

}  // namespace

std::string as_typed(const std::string& word) {
    const bool plain =
        !word.empty() &&
        word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+") == word.npos;
    if (plain) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

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
