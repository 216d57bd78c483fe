#pragma once

#include <filesystem>

#include "assignment.h"

namespace grade {

/// Writes what students get into a new folder: the project without solution/ and tests/, with fresh blanks in
/// starter/fragments, and once more in grader/blanks: where there is no solution, the grader links with those.
///
/// Throws std::runtime_error where the folder is not empty or cannot be written, rt::InputError where the solution has
/// no proper markers.
void hand_out(const std::filesystem::path& project, const Assignment& assignment, const std::filesystem::path& folder);

}  // namespace grade
