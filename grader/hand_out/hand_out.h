#pragma once

#include <filesystem>
#include <vector>

#include "assignment/assignment.h"

namespace grade {

/// students: a kit. everybody: the same with archives, for a folder that its users cannot write to, as below /usr.
enum class For { students, everybody };

/// Writes what students get into a new folder, a kit: starter/ in source with fresh blanks, scenes, the handout
/// (and the page that the build makes of it, where there is one), GLM's headers, and in grader/MACHINE/ the grader,
/// built: program, framework, reference fragments as objects without names
/// or debug information, and the libraries that a plain system lacks, with their licences. All of it or nothing.
///
/// Throws rt::InputError where the folder is not empty, or another hand-out is of another assignment;
/// std::runtime_error where a part is not built or cannot be written; rt::InputError where the solution has no proper
/// markers.
///
/// project  the project's folder
/// built    the toolchain file of the kit's parts: build/release/kit.toml
/// others   hand-outs from other kinds of machines, whose grader/MACHINE/ come along
/// whom     who will use it
void hand_out(const std::filesystem::path& project, const Assignment& assignment, const std::filesystem::path& built,
              const std::filesystem::path& folder, const std::vector<std::filesystem::path>& others = {},
              For whom = For::students);

/// "x86_64-linux": the kind of machine this is.
std::string kind_of_machine();

}  // namespace grade
