#include "rt/fragments.h"

namespace rt {

/// Where a point of a moving shape is at a time.
///
///     point + time x velocity
///
/// point     at time 0 [world]
/// velocity  [m/s]
/// time      [s]
/// returns   the point then [world]
/// blank     the point at time 0
///
/// Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
vec3 moved(vec3 point, vec3 velocity, Real time) {
    vec3 way = velocity * time;
    return point + way;
}

}  // namespace rt
