#pragma once

#include "rt/files/toml_table.h"
#include "rt/scene.h"

/// The parts of a scene file that are long enough to have files of their own. All throw InputError.
/// Nobody needs this file for the assignment.
namespace rt {

/// [materials.NAME], each of which becomes a material of the scene.
void read_materials(const Table& table, Scene& scene);

/// [[shape]]: becomes a shape or a mesh of the scene, whose materials must be there already.
void read_shape(const Table& table, Scene& scene);

/// v / |v| without overflow or underflow. A zero vector stays zero.
vec3 direction(vec3 v);

}  // namespace rt
