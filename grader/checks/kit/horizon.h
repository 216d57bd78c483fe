#pragma once

#include "checks/kit/draw.h"

namespace grade {

/// A2: what is left of the false patterns that regular points of a pixel see in a checkerboard towards its horizon.
Check horizon(Generator& random);

}  // namespace grade
