#include "build/hand_out.h"

#include <fmt/format.h>

#include <array>
#include <set>

#include "build/files.h"
#include "build/strip.h"

namespace grade {

namespace {

/// What is handed out, by name: nothing that somebody has put beside it.
constexpr std::array entries = {".ci/prepare.sh", "CMakeLists.txt", "CMakePresets.json", "LICENSE", "assignment.toml",
                                "grade",          "grader",         "handout.md",        "scenes",  "starter",
                                "vcpkg.json"};

/// Hidden files, what builds leave behind, and what needs the solution stay here.
bool is_left_out(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with(".") || name.starts_with("build") || name.starts_with("__") || name == "render_pictures";
}

void copy_folder(const fs::path& from, const fs::path& to) {
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(from)) {
        const fs::path target = to / entry.path().filename();
        const bool own_build =
            entry.is_directory() && from.filename() == "grader" && entry.path().filename() == "build";
        if (is_left_out(entry.path()) && !own_build) continue;
        if (entry.is_directory()) copy_folder(entry.path(), target);
        else if (entry.is_regular_file()) fs::copy_file(entry.path(), target);
    }
}

}  // namespace

void hand_out(const fs::path& project, const Assignment& assignment, const fs::path& folder) {
    if (fs::exists(folder) && !fs::is_empty(folder))
        throw std::runtime_error(fmt::format("{}: is not empty; expected a new folder", folder.string()));
    std::set<std::string> given;
    for (const Fragment& fragment : assignment.fragments)
        if (fragment.given) given.insert(fragment.name);
    const auto blanks = make_starter((project / "solution").string(), given);

    for (const char* entry : entries) {
        const fs::path from = project / entry, to = folder / entry;
        fs::create_directories(to.parent_path());
        if (fs::is_directory(from)) copy_folder(from, to);
        else fs::copy_file(from, to);
    }
    write_starter(blanks, (folder / "starter/fragments").string());
    write_starter(blanks, (folder / "grader/blanks").string());
}

}  // namespace grade
