#pragma once

#include <filesystem>
#include <string>

namespace grade::authoring {

/// Throws rt::InputError for what is no name of a fragment, scene, check or mistake.
void require_name(const std::string& name);

/// Throws rt::InputError for a fragment's name that has a meaning already: to C++, to the command line, or to the
/// framework.
void require_free_name(const std::filesystem::path& project, const std::string& name);

}  // namespace grade::authoring
