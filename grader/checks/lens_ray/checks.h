#pragma once

#include "checks/kit/scene.h"

/// Pictures of the lens with a light or with time: whether its numbers are its own.
namespace grade::lens_ray {

Check two_colors(Generator& random);
Check adding_up(Generator& random);

}  // namespace grade::lens_ray
