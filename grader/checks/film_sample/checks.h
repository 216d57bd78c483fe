#pragma once

#include "checks/kit/scene.h"

/// Checks of film_sample that need much text.
namespace grade::film_sample {

/// Two slanted edges, one for each axis of the film: their places, widths and noise.
Check slanted_edges(Generator& random);

/// A2: what is left of the false patterns that regular points of a pixel see in a checkerboard towards its horizon.
Check horizon(Generator& random);

}  // namespace grade::film_sample
