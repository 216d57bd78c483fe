#pragma once

#include <string>

#include "stress/record.h"

namespace grade {

/// The decades of a family as a bar, SVG: all that were tried, those of ordinary scenes, those that pass, and the
/// solution's.
std::string reach_bar(const FamilyRecord& family);

/// The error at each decade over the one that is allowed there, both axes logarithmic, SVG.
std::string error_plot(const FamilyRecord& family);

}  // namespace grade
