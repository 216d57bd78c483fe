#include "rt/fragments.h"

namespace rt {

/// The ray from a pinhole camera through a point of its film.
///
///     d = x right + y up - back, y = h (1 - 2 film_y / size_y), x = h (2 film_x - size_x) / size_y, h = tan_half_fov
///
/// camera   see parts.h: right, up and back are unit vectors at right angles; the camera looks along -back
/// film     a point of the film [pixel]: x to the right, y down, (0, 0) the top left corner of the image and
///          (size.x, size.y) the bottom right one, so that (0.5, 0.5) is the centre of the first pixel
/// returns  the ray from the eye, direction of unit length [world], near 0, far inf
/// blank    straight ahead for each film point
///
/// Source: Shirley and Marschner, "Fundamentals of Computer Graphics", section 4.3.
Ray camera_ray(const Camera& camera, vec2 film) {
    // BEGIN SOLUTION
    const Real scale = 2 * camera.tan_half_fov / camera.size.y;
    const Real x = scale * (film.x - 0.5 * camera.size.x);
    const Real y = scale * (0.5 * camera.size.y - film.y);
    return {camera.eye, unit(x * camera.right + y * camera.up - camera.back), 0, inf};
    // END SOLUTION: return not_started(Ray{camera.eye, -camera.back, 0, inf});
}

}  // namespace rt
