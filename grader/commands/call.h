#pragma once

#include <string>

namespace CLI {
class App;
}

namespace grade {

struct CallArguments {
    std::string fragment, arguments, submission;
    bool debugger = false, trusted = false;
};

CLI::App* add_call_command(CLI::App& app, CallArguments& arguments);

/// grade call: one call of a fragment, with the student's own prints, and what is expected. Returns the exit code: 0; 1
/// where the answer is another.
int run_call(const CallArguments& arguments, const std::string& toolchain);

}  // namespace grade
