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

/// A command: the file that puts its options on the command line keeps the arguments, as long as `run` is there.
struct Command {
    CLI::App* app;
    std::function<int(const Context&)> run;  // returns the exit code
    bool needs_compiler = true;              // else the toolchain may be empty
};

}  // namespace grade
