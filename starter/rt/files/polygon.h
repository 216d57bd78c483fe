#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rt/math.h"

/// Nobody needs this file for the assignment.
namespace rt {

/// Splits a polygon into triangles, each three places in the list of its corners; a convex one as a fan about its first
/// corner. Corners that repeat the one before, and polygons without area, give none.
///
/// returns  nothing where two edges cross, or there are more than 4096 corners and it is not convex
///
/// Source: Meisters, "Polygons Have Ears", The American Mathematical Monthly 82(6), 1975.
std::optional<std::vector<std::array<int, 3>>> split_polygon(const std::vector<vec3>& corners);

}  // namespace rt
