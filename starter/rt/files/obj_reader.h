#pragma once

#include <string>

#include "rt/scene.h"

/// Nobody needs this file for the assignment.
namespace rt {

/// Reads the triangles of a Wavefront OBJ file; faces with more corners must be convex. Groups and materials are
/// ignored.
///
/// smooth   give each vertex a normal: the file's if every corner of every face has one, else the mean of the faces
///          around the vertex, weighted by area
/// errors   InputError with the position in the OBJ file; std::system_error if it cannot be read at all
Mesh read_obj(const std::string& path, bool smooth);

}  // namespace rt
