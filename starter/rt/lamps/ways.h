#pragma once

#include <string>
#include <vector>

#include "rt/scene.h"

namespace rt {

/// How lamps with extent are sampled: as the scene says; where it says nothing, as takes the least time to the same
/// error, by a rule that tests/bench/choices.py has measured. Only the scene decides, never what fragments answer: the
/// picture of a wrong fragment is drawn in the same way as that of the right one. Nobody needs this file for the
/// assignment.
struct LampWays {
    struct Way {
        bool on = false;
        std::string why;
    };
    Way solid_angle;          // quads by solid angle, not by area
    Way one_lamp;             // one of them at each point
    Way multiple_importance;  // for glossy lobes too
    Way media_lit;            // where media scatter
};

/// lamps  their places in the scene's shapes; at least one
LampWays choose_ways(const Scene& scene, const std::vector<int>& lamps);

}  // namespace rt
