#pragma once

#include <string>
#include <vector>

#include "convergence/measure.h"
#include "programs/programs.h"

namespace CLI {
class App;
}

namespace grade::convergence {

struct ConvergeArguments {
    std::vector<std::string> words;  // a submission, scenes
    std::string json, csv, out, folder;
    Amounts amounts;
    BuildSettings build{.only_changed = true};
    bool fresh = false, require = false;
};

CLI::App* add_converge_command(CLI::App& app, ConvergeArguments& arguments);

/// grade converge: error against run time.
///
/// command  as it was typed
/// Returns the exit code: 0; 1 with --require where the submission is biased or breaks down. Throws what the other
/// commands do.
int converge(const ConvergeArguments& arguments, const std::string& toolchain, const std::string& command);

}  // namespace grade::convergence
