#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace grade {

struct StressArguments {
    std::string submission, json, html;
    std::vector<std::string> only;
    int jobs = 0;
    double time_limit = 10, rays = 1e8;
    bool trusted = false, many = false, list = false, require = false;
};

/// grade stress: how extreme a scene a submission's fragments survive.
CLI::App* add_stress_command(CLI::App& app, StressArguments& arguments);

/// Returns the exit code: 0; 1 with --require where the scored tier is not full; 2 for a usage error.
int run_stress(const StressArguments& arguments, const std::string& toolchain, const std::string& command);

}  // namespace grade
