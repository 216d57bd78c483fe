#pragma once

#include "checks/kit/outline.h"

/// What checks of where things are seen look at: a bright figure before a camera that looks down.
namespace grade {

inline constexpr const char* bright_lamp = "[materials.lamp]\nemission = 1\n\n";

View view_down(const Place& place, double height, double vfov);

/// A quad near the middle of the plane z, turned by any angle, whose front is up.
rt::Quad any_quad(Generator& random, const Place& place, double z, double size);

Check slanted_quad(Generator& random);

}  // namespace grade
