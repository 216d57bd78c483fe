#pragma once

#include <string>

namespace CLI {
class App;
}

namespace grade {

struct TheoryArguments {
    std::string submission, name;
};

CLI::App* add_theory_command(CLI::App& app, TheoryArguments& arguments);

/// grade theory: checks a submission's theory.toml, or with a name writes a new one. Returns the exit code: 0; 1 where
/// an answer is wrong or missing.
int run_theory(const TheoryArguments& arguments, const std::string& toolchain);

}  // namespace grade
