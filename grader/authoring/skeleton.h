#pragma once

#include <map>
#include <string>

#include "authoring/source.h"

/// New texts, from the files of templates/: FILL IN stands where something is to be written.
namespace grade::authoring {

/// A file of authoring/templates with the values in place of @their names@.
std::string from_template(const fs::path& project, const std::string& name,
                          const std::map<std::string, std::string>& values);

/// The solution's file: its comment and its blank are those of `like`, or made from the types.
std::string solution_skeleton(const fs::path& project, const Declaration& fragment, const std::string& like);

/// The file of checks; fallback: what the blank does.
///
/// id  of the handout's list of statistics
std::string checks_skeleton(const fs::path& project, const Declaration& fragment, const std::string& solution,
                            const std::string& id);

/// One more check, to stand before the function of the file.
std::string check_skeleton(const fs::path& project, const Declaration& fragment, const std::string& name,
                           const std::string& id);

/// Throws rt::InputError for a type that protocol/rows.h does not write.
void require_known_types(const Declaration& fragment);

}  // namespace grade::authoring
