#pragma once

#include "checks/kit/scene.h"
#include "statistics/region.h"

namespace grade {

/// G1: whether pixels share random numbers. `what` is drawn, "position in the pixel", or is always `otherwise`, "the
/// middle", which looks the same.
Statistic own_numbers(const Region& region, int samples, const std::string& what, const std::string& otherwise);

}  // namespace grade
