#pragma once

#include "calibration/workshop.h"

namespace grade::calibration {

/// Grades the first wrong variant of each fragment, or all that were asked for by name, and all right ones; only
/// fragments that are changed. Prints a line for each, with its first hint under the first seed, and what other seeds
/// say differently.
///
/// seeds  how many: 1, 2, ...
/// Returns whether each wrong variant fails and each right one passes under all of them.
bool grade_fast(const Workshop& workshop, bool by_name, int seeds, int jobs);

}  // namespace grade::calibration
