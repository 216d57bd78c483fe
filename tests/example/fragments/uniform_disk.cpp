#include "rt/fragments.h"

namespace rt {

/// A point of the unit disk, uniformly distributed.
///
///     r = sqrt(u.x),    phi = 2 pi u.y
///
/// Any other map of the square that is uniform on the disk is as good.
///
/// u        random point of the unit square, 0 <= u < 1
/// returns  the point, |p| <= 1, and its density 1/pi
/// blank    the centre
///
/// Source: Shirley, "Nonuniform Random Point Sets via Warping", Graphics Gems III.
DiskSample uniform_disk(vec2 u) {
    // rejection: first the square around the disk, then away with the corners
    vec2 p;
    do {
        p = 2.0 * u - 1.0;
    } while (dot(p, p) > 1);
    return {p, 1 / pi};
}

}  // namespace rt
