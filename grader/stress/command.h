#pragma once

#include <string>

#include "stress/run.h"

namespace CLI {
class App;
}

namespace grade::stress {

struct StressArguments {
    std::string submission, json, html;
    StressSettings settings;
    double rays = 1e8;  // of the big counts
    bool many = false, list = false, require = false;
};

/// grade stress: how extreme a scene a submission's fragments survive.
CLI::App* add_stress_command(CLI::App& app, StressArguments& arguments);

/// Returns the exit code: 0; 1 with --require where the scored tier is not full; 2 for a usage error.
int run_stress(const StressArguments& arguments, const std::string& toolchain, const std::string& command);

}  // namespace grade::stress
