#pragma once

#include <functional>
#include <string>

namespace grade {

enum ExitCode { graded = 0, below_required = 1, usage = 2, infrastructure = 3, stopped = 130 };

/// Runs a command to its exit code; what it throws is told on stderr.
int exit_code_of(const std::function<int()>& command);

/// The command as it can be typed again.
std::string command_of(int argc, char** argv);

}  // namespace grade
