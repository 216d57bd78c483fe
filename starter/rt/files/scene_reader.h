#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "rt/scene.h"

/// Scenes, meshes and images in files. Nobody needs this folder for the assignment.
namespace rt {

/// What is wrong with an input file, as "file:line:column: what is wrong; what was expected".
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads a scene from a TOML file. Throws InputError.
Scene read_scene(const std::string& path);

/// Reads a scene from text; path names it in errors and is where meshes are looked for. Throws InputError.
Scene parse_scene(std::string_view text, const std::string& path);

}  // namespace rt
