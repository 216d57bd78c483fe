#pragma once

#include "checks/kit/check.h"

namespace grade {

/// Two slanted edges, one for each axis of the film: their places, widths and noise.
Check slanted_edges(Generator& random);

}  // namespace grade
