#include "rt/fragments.h"

namespace rt {

/// A random time while the shutter is open.
///
/// shutter  open and close [s], open <= close
/// u        random number, 0 <= u < 1
/// returns  time, uniformly distributed [s]
/// blank    when the shutter opens
///
/// Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
Real shutter_time(const Shutter& shutter, Real u) { return (1 - u) * shutter.open + u * shutter.close; }

}  // namespace rt
