#include "rt/fragments.h"

namespace rt {

/// The ray through a point of a thin lens that meets the pinhole's ray in the plane in focus: depth of field.
///
///     origin = eye + R (x right + y up),    towards eye + t d,    t the distance along d at which the plane in focus
///     lies
///
/// (x, y) is a uniform point of the unit disk. The plane is at right angles to the axis, camera.focus in front of the
/// lens, so t depends on d; it may be infinitely far away.
///
/// camera   lens_radius R, focus, and the axes right, up, back [world]
/// pinhole  the ray of camera_ray: origin the eye, unit direction d [world]
/// u        random point of the unit square, 0 <= u < 1
/// returns  the ray, direction of unit length [world], near 0, far inf
/// blank    the pinhole's ray
///
/// Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
Ray lens_ray(const Camera& camera, const Ray& pinhole, vec2 u) {
    double r = camera.lens_radius * u.x;
    double phi = 2 * pi * u.y;
    vec3 origin = camera.eye + r * cos(phi) * camera.right + r * sin(phi) * camera.up;
    vec3 forward = -camera.back;
    double t = camera.focus / dot(pinhole.direction, forward);
    if (t == inf) return {origin, pinhole.direction, 0, inf};
    vec3 in_focus = camera.eye + t * pinhole.direction;
    return {origin, unit(in_focus - origin), 0, inf};
}

}  // namespace rt
