#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace grade {

/// What a command is run with, beside its own arguments.
struct Context {
    std::string toolchain;  // the file that the build wrote
    std::string command;    // as it can be typed again
};

/// A command. `run` owns the arguments that the options on the command line are read into.
struct Command {
    CLI::App* app;
    std::function<int(const Context&)> run;  // returns the exit code
    bool needs_compiler = true;              // else the toolchain may be empty
};

}  // namespace grade
