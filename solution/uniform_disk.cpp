#include "rt/fragments.h"

namespace rt {

/// A point of the unit disk, uniformly distributed.
///
///     r = sqrt(u.x),    phi = 2 pi u.y
///
/// Another map of the square with this density is as good.
///
/// u        random point of the unit square, 0 <= u < 1
/// returns  the point, |p| <= 1, and its density 1/pi
/// blank    the centre
///
/// Source: Shirley, "Nonuniform Random Point Sets via Warping", Graphics Gems III.
DiskSample uniform_disk(vec2 u) {
    // BEGIN SOLUTION
    return {std::sqrt(u.x) * unit_circle(u.y), 1 / pi};
    // END SOLUTION: return not_started(DiskSample{vec2(0), 1 / pi});
}

}  // namespace rt
