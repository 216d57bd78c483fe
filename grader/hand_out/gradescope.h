#pragma once

#include <cstdint>
#include <filesystem>

namespace grade {

/// Writes what Gradescope takes for an autograder: a kit, setup.sh and run_autograder. It compiles nothing of the
/// grader there. Throws std::runtime_error.
///
/// project  the project's folder
/// kit      what hand_out has written
/// seed     of all gradings, so that the same submission gets the same points
void write_gradescope(const std::filesystem::path& project, const std::filesystem::path& kit, std::uint64_t seed,
                      const std::filesystem::path& zip);

}  // namespace grade
