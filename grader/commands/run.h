#pragma once

#include <string>
#include <vector>

#include "studies/command.h"

namespace grade {

/// 1 is a command's own: below what is required, or something is off. The last two are a shell's, for a program that
/// SIGINT or SIGPIPE ends.
enum ExitCode { graded = 0, usage = 2, infrastructure = 3, stopped = 130, unread = 141 };

/// A word as it can be typed into a shell.
std::string as_typed(const std::string& word);

/// Reads the words, and runs the first command of the table that is among them: the app itself, where it is one, is the
/// last. What it throws is told on stderr. Returns the exit code.
int run_commands(CLI::App& app, const std::vector<Command>& commands, int argc, char** argv);

}  // namespace grade
