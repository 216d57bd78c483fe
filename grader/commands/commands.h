#pragma once

#include "studies/command.h"

/// The commands of the first program.
namespace grade {

Command picture_command(CLI::App& app);
Command call_command(CLI::App& app);
Command theory_command(CLI::App& app);
Command hand_out_command(CLI::App& app);
Command describe_command(CLI::App& app);
Command grade_command(CLI::App& app);  // a grading, which has no word of its own

/// grade WORD...: the command line. Returns the exit code.
int run_command_line(int argc, char** argv);

}  // namespace grade
