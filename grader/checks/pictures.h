#pragma once

#include "checks/check.h"

/// Pictures for the fragments of the film and of lights with extent.
namespace grade {

Check slanted_edges(Generator& random);  // film_sample
Check thin_lamps(Generator& random);     // pixel_mean
Check lamp_steps(Generator& random);     // pixel_mean
Check lit_floor(Generator& random);      // direct_light
Check lamp_highlight(Generator& random); // direct_light

}  // namespace grade
