#pragma once

#include <string>

/// What handout and editors are told of scene files, from the list of their keys: rt/files/scene_keys.h.
namespace grade {

/// Rows of the handout: the keys of a table, "render", with those of tables in it; or of the types of one, "shape"; of
/// the file itself: "". Empty: there is no such table.
std::string describe_keys(const std::string& table);

/// scenes/scene.schema.json.
std::string scene_schema();

}  // namespace grade
