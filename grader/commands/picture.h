#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace grade {

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

}  // namespace grade
