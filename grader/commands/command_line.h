#pragma once

namespace grade {

/// grade WORD...: the command line. Each subcommand is a function that returns the exit code, and so does this.
int run_command_line(int argc, char** argv);

}  // namespace grade
