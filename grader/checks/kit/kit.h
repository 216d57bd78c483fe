#pragma once

#include <fmt/format.h>

#include <array>

/// What the checks of most fragments need: how they ask, judge, tell, and write scenes.
#include "checks/kit/draw.h"
#include "checks/kit/estimate.h"
#include "checks/kit/formula.h"
#include "checks/kit/later.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/render_check.h"
