#pragma once

#include <vector>

#include "rt/plan.h"

namespace rt {

/// The fragments that one stage calls.
struct Calls {
    const char* stage;
    std::vector<const char*> fragments;
};

/// Which fragments the stages of a plan call, stage by stage. Which others these call is their author's affair.
std::vector<Calls> calls_of(const RenderPlan& plan);

}  // namespace rt
