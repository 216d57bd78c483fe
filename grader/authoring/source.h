#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/calls/arguments.h"

/// The texts of an assignment's tree, as an instructor edits them.
namespace grade::authoring {

namespace fs = std::filesystem;

/// Throws rt::InputError where it cannot be read.
std::string must_read(const fs::path& path);

/// A fragment as fragments.h declares it.
struct Declaration {
    std::string line;  // "vec3 moved(vec3 point, vec3 velocity, Real time);"
    Signature signature;
};

/// None: the header declares no such fragment on a line of its own.
std::optional<Declaration> declaration_of(const std::string& fragment, const std::string& header);

/// The comment above the function, without its slashes, line by line; empty: there is none.
std::vector<std::string> comment_of(const std::string& fragment, const std::string& text);

/// The text between a fragment's heading in the handout and the next heading; none: there is no such section.
std::optional<std::string> section_of(const std::string& fragment, const std::string& handout);

/// "file:line:1" of a place in its text.
std::string place_of(const fs::path& file, const std::string& text, std::size_t at);

/// The words that a new file holds where something is to be written.
constexpr std::string_view to_fill_in = "FILL IN";

}  // namespace grade::authoring
