#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace grade::course {

struct ClassArguments {
    std::string submissions, out, shard;
    std::optional<std::uint64_t> seed;
    int jobs = 0;
    double time_limit = 5;
    bool trusted = false, pictures = false;
};

CLI::App* add_class_command(CLI::App& app, ClassArguments& arguments);

/// grade class SUBMISSIONS: grades what has no record yet, then writes tables and pages. Returns the exit code: 0; 2
/// where no submission can be read; 3 where the machine failed for some, which the next call takes up.
int run_class(const ClassArguments& arguments, const std::string& toolchain);

struct MergeArguments {
    std::string out;
    std::vector<std::string> parts;
};

CLI::App* add_merge_command(CLI::App& app, MergeArguments& arguments);

/// grade merge OUT PART...: the records of all parts, and the tables and pages of the whole.
int run_merge(const MergeArguments& arguments);

}  // namespace grade::course
