#pragma once

#include "rt/math.h"

namespace rt {

/// A line on the standard error: how far the picture is, and the seconds that are left. stopping: its end has been
/// asked for. Nobody needs this file for the assignment.
void show_bar(Real done, Real seconds_left, bool stopping);

/// Takes the line away.
void clear_bar();

}  // namespace rt
