#pragma once

#include <string>

#include "programs/programs.h"

namespace CLI {
class App;
}

namespace grade::lesson {

struct LessonArguments {
    std::string submission, out;
    BuildSettings build{.only_changed = true};
};

CLI::App* add_lesson_command(CLI::App& app, LessonArguments& arguments);

/// grade lesson: the errors of part 1's fragments against the number of points, as a table and as plots: the same bytes
/// on each run. Throws what the other commands do.
void run_lesson(const LessonArguments& arguments, const std::string& toolchain);

}  // namespace grade::lesson
