#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grade {

/// The fragment that a file is meant to be, though its name says so only nearly: hit_sphere-1.cpp, hit_sphere (1).cpp,
/// Hit_Sphere.cpp, hitsphere.cpp, doe_jane_4711_hit_sphere.cpp, hit_sphere.cpp.txt, hit_shpere.cc. None: it is none of
/// them, or has the very name of one.
///
/// file  a name without folders
std::optional<std::string> nearly_named(std::string_view file, const std::vector<std::string>& fragments);

/// Whether a folder's name says that what is in it is no longer in use: old, backup_2, Copy of fragments.
bool is_set_aside(std::string_view folder);

}  // namespace grade
