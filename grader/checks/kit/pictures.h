#pragma once

#include "checks/kit/check.h"
#include "statistics/region.h"

/// Pictures for the fragments of the film, the lens, the shutter, media, and lights with extent.
namespace grade {

Check slanted_edges(Generator& random);  // film_sample
Check fine_stripes(Generator& random);   // film_sample
Check thin_lamps(Generator& random);     // pixel_mean
Check lamp_steps(Generator& random);     // pixel_mean
Check lit_floor(Generator& random);      // direct_light
Check lamp_highlight(Generator& random); // direct_light
Check white_medium(Generator& random);   // free_flight, scatter_direction
Check two_colors(Generator& random);     // lens_ray
Check adding_up(Generator& random);      // lens_ray
Check passing_train(Generator& random);  // shutter_time
Check streak(Generator& random);         // shutter_time

/// G1: whether pixels share random numbers. `what` is drawn, "position in the pixel", or is always `otherwise`, "the
/// middle", which looks the same.
Statistic own_numbers(const Region& region, int samples, const std::string& what, const std::string& otherwise);

}  // namespace grade
