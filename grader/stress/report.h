#pragma once

#include <string>

#include "stress/record.h"

/// A record for people.
namespace grade::stress {

/// One line for each family: what is swept, the decades that pass, and the solution's.
std::string table(const StressRecord& record, bool color);

/// The record as one page that needs nothing else: what passes, and how the error grows.
///
/// handout  where the page finds the handout; empty: nowhere
std::string page(const StressRecord& record, const std::string& title, const std::string& handout = "");

/// The decades of a family as a bar, SVG: all that were tried, those of ordinary scenes, those that pass, and the
/// solution's.
std::string reach_bar(const FamilyRecord& family);

/// The error at each decade over the one that is allowed there, both axes logarithmic, SVG.
std::string error_plot(const FamilyRecord& family);

}  // namespace grade::stress
