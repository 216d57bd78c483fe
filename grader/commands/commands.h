#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judging/grading.h"

namespace CLI {
class App;
}

/// The commands of the first program: for each its arguments, what puts them on the command line, and what runs it and
/// returns the exit code.
namespace grade {

struct GradeArguments {
    std::vector<std::string> words;  // a submission, and fragments
    std::string json, html, own_scene;
    std::optional<std::uint64_t> seed;
    std::optional<double> required;
    GradingSettings settings;  // those that have an option
    bool fresh = false, watch = false;
};

/// The options of a grading, which has no word of its own.
void add_grade_options(CLI::App& app, GradeArguments& arguments);

/// grade [SUBMISSION] [FRAGMENT...]. Returns the exit code: 0; 1 below what is required.
int run_grade(const GradeArguments& arguments, const std::string& toolchain, const std::string& command);

struct PictureArguments {
    std::string scene, submission, with, out;
    std::vector<std::string> mine;
    std::vector<int> size;
    int samples = 0;
    std::uint64_t seed = 1;
    double time_limit = 600;
    bool trusted = false;
};

CLI::App* add_picture_command(CLI::App& app, PictureArguments& arguments);

/// grade picture: a scene as the submission's fragments draw it, as the solution's do, and the difference; or points of
/// a warp. Returns the exit code: 0; 1 where the submission's program gave no picture.
int run_picture(const PictureArguments& arguments, const std::string& toolchain);

struct CallArguments {
    std::string fragment, arguments, submission;
    bool debugger = false, trusted = false;
};

CLI::App* add_call_command(CLI::App& app, CallArguments& arguments);

/// grade call: one call of a fragment, with the student's own prints, and what is expected. Returns the exit code: 0; 1
/// where the answer is another.
int run_call(const CallArguments& arguments, const std::string& toolchain);

struct TheoryArguments {
    std::string submission, name;
};

CLI::App* add_theory_command(CLI::App& app, TheoryArguments& arguments);

/// grade theory: checks a submission's theory.toml, or with a name writes a new one. Returns the exit code: 0; 1 where
/// an answer is wrong or missing.
int run_theory(const TheoryArguments& arguments, const std::string& toolchain);

struct HandOutArguments {
    std::string folder, gradescope;
    std::vector<std::string> others;
    std::optional<std::uint64_t> seed;
    bool installed = false;
};

CLI::App* add_hand_out_command(CLI::App& app, HandOutArguments& arguments);

/// grade hand-out: a kit. Returns the exit code.
int run_hand_out(const HandOutArguments& arguments, const std::string& toolchain);

struct DescribeArguments {
    std::string handout, students;
};

CLI::App* add_describe_command(CLI::App& app, DescribeArguments& arguments);

/// grade describe: tables of points, of checks, and of the keys of scenes. Returns the exit code.
int run_describe(const DescribeArguments& arguments, const std::string& toolchain);

/// grade WORD...: the command line. Returns the exit code.
int run_command_line(int argc, char** argv);

}  // namespace grade
