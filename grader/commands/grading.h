#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace grade {

struct GradeArguments {
    std::vector<std::string> words;  // a submission, and fragments
    std::string json, html, keep, own_scene;
    std::optional<std::uint64_t> seed;
    std::optional<double> required;
    int jobs = 0;
    double time_limit = 5;
    bool trusted = false, fresh = false, watch = false;
};

/// The options of a grading, which has no word of its own.
void add_grade_options(CLI::App& app, GradeArguments& arguments);

/// grade [SUBMISSION] [FRAGMENT...]. Returns the exit code: 0; 1 below what is required.
int run_grade(const GradeArguments& arguments, const std::string& toolchain, const std::string& command);

}  // namespace grade
