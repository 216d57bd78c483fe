#pragma once

#include "checks/kit/check.h"

/// Whether the numbers of the lens are its own: pictures of the lens with a light or with time.
namespace grade {

Check two_colors(Generator& random);
Check adding_up(Generator& random);

}  // namespace grade
