#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "assignment/assignment.h"

/// New parts of an assignment. Each returns the files that it makes or changes, with their new texts; nothing is
/// written yet, and no file of a new part's name may be there. All throw rt::InputError.
namespace grade::authoring {

namespace fs = std::filesystem;

using Files = std::map<fs::path, std::string>;  // relative to the project's folder

struct NewFragment {
    std::string name;
    std::string declaration;  // "DiskSample ring(Real inner, vec2 u)"; empty: that of `like`
    std::string like;         // the one that it stands after; empty: the last one of the part
    std::string part;         // empty: that of `like`, else the last one
    double points = 1;
};

/// A line of fragments.h and one of assignment.toml, the solution with its markers, the checks, the blank and the
/// section of the handout.
Files new_fragment(const fs::path& project, const Assignment& assignment, const NewFragment& fragment);

/// scenes/NAME.toml; as another one, or a ball on a floor.
Files new_scene(const fs::path& project, const std::string& name, const std::string& like);

/// One more check in the file of a fragment.
Files new_check(const fs::path& project, const std::string& name, const std::string& fragment);

struct NewVariant {
    std::string name, fragment;
    std::string old_text, new_text;  // of the solution
    std::string what;                // in a few words
    std::string says;                // words of which the hint must hold one: "sign|back"; empty: any hint will do
    bool right = false;              // another right way; else a mistake
};

/// A patch in tests/variants, and its row in the README there.
Files new_variant(const fs::path& project, const NewVariant& variant);

}  // namespace grade::authoring
