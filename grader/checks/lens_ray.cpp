#include "checks/fragment_checks.h"
#include "checks/probe_check.h"
#include "checks/warp.h"

namespace grade {

namespace {

using rt::Camera, rt::Ray, rt::vec2, rt::vec3;

Camera camera_of(const Row& in) { return argument<0, Camera, Ray, vec2>(in); }
Ray pinhole_of(const Row& in) { return argument<1, Camera, Ray, vec2>(in); }

/// Where on the lens a ray starts, in its radius: across, up, and along the axis.
vec3 on_lens(const Row& in, const Row& out) {
    const Camera camera = camera_of(in);
    const vec3 p = from_row<Ray>(out).origin - camera.eye;
    return vec3(rt::dot(p, camera.right), rt::dot(p, camera.up), rt::dot(p, camera.back)) / camera.lens_radius;
}

/// How far apart a ray and the pinhole's ray are in the plane at a distance along the axis, in the lens's radius.
double apart(const Row& in, const Row& out, double z) {
    const Camera camera = camera_of(in);
    const auto at = [&](const Ray& ray) {
        const double start = rt::dot(ray.origin - camera.eye, -camera.back), speed = rt::dot(ray.direction, -camera.back);
        return ray.origin + (z - start) / speed * ray.direction;
    };
    return glm::length(at(from_row<Ray>(out)) - at(pinhole_of(in))) / camera.lens_radius;
}

}  // namespace

Checks check_lens_ray(Generator& random) {
    Camera camera;
    const rt::Frame axes = rt::frame_about(direction(random));
    camera.eye = box(random, -2, 2);
    camera.right = axes.x, camera.up = axes.y, camera.back = axes.z;
    camera.lens_radius = between(random, 0.05, 0.3);
    camera.focus = between(random, 2, 6);
    camera.tan_half_fov = 0.6;
    const auto rays = [](Camera lens) {
        return [lens](Generator& draws) {
            return repeat(rows_of(1024, [lens](Generator& draw) {
                const vec2 film = 1.2 * square(draw) - 0.6;
                const Ray pinhole{lens.eye, rt::unit(film.x * lens.right + film.y * lens.up - lens.back), 0, rt::inf};
                return row(lens, pinhole, square(draw));
            })(draws));
        };
    };
    Statistic plane = property("D2", "distance of the origin from the lens, in its radius",
        [](const Row& in, const Row& out) {
            const vec3 p = on_lens(in, out);
            return std::max(std::abs(p.z), std::hypot(p.x, p.y) - 1);
        },
        1e-3, "rays start beside the lens: origin = eye + lens_radius (x right + y up), (x, y) in the unit disk");
    Statistic sharp = property("D3", "distance between rays of one film point in the plane in focus, in the lens's radius",
        [](const Row& in, const Row& out) { return apart(in, out, camera_of(in).focus); }, 0.01,
        "rays of one film point do not meet in the plane in focus");
    sharp.cause = [](const Observation& seen) -> std::string {
        double sphere = 0, parallel = 0, double_plane = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
            const Camera camera = camera_of(seen.inputs[k]);
            const Ray pinhole = pinhole_of(seen.inputs[k]);
            const vec3 d = from_row<Ray>(seen.outputs[k]).direction;
            sphere = std::max(sphere, apart(seen.inputs[k], seen.outputs[k], camera.focus * -rt::dot(pinhole.direction, camera.back)));
            parallel = std::max(parallel, glm::length(rt::unit(d) - pinhole.direction));
            double_plane = std::max(double_plane, apart(seen.inputs[k], seen.outputs[k], 2 * camera.focus));
        }
        if (sphere < 0.01) return "the focus is measured along the ray, so corners are blurred: it is the distance of a plane, along the axis";
        if (parallel < 1e-3) return "all rays of a film point are parallel: they must meet in the plane in focus";
        if (double_plane < 0.01) return "the plane in focus is at twice its distance";
        return "";
    };
    const auto radius = [](const Row& in, const Row& out) { const vec3 p = on_lens(in, out); return p.x * p.x + p.y * p.y; };
    Statistic size = mean_of("D1", "mean square of the point on the lens, in its radius", radius, 0.5, 0.5,
        by_ratio("the mean square of the point on the lens", {{0.25, "is lens_radius used as a diameter?"}, {4, "is lens_radius doubled?"}, {4.0 / 3, "the lens is a square, not a disk"},
                                                              {2.0 / 3, "points crowd in the middle of the lens: a square root is missing"}, {0, "all rays go through the middle of the lens: it is a pinhole"}}));
    Statistic even = uniform_in_square("D2", "chi-squared of equal areas of the lens",
        [=](const Row& in, const Row& out) { const vec3 p = on_lens(in, out); return vec2(p.x * p.x + p.y * p.y, turn(p.x, p.y)); }, 8, 8,
        always("equal areas of the lens do not get equally many rays: it is a disk, sampled evenly, with two numbers"));
    Statistic ray = property("D1", "length of the direction, off 1 by, or an interval that is not 0 to infinity",
        [](const Row&, const Row& out) {
            const Ray r = from_row<Ray>(out);
            return std::abs(glm::length(r.direction) - 1) + (r.near >= 0 && r.near < 0.01 && r.far > 1e6 ? 0 : 1);
        },
        1e-3, "the direction is no unit vector, or the ray's interval is not 0 to infinity");

    Camera distant = camera;
    distant.focus = rt::inf;
    Statistic parallel = property("D1", "angle between rays of one film point, with the focus at infinity [rad]",
        [](const Row& in, const Row& out) { return glm::length(from_row<Ray>(out).direction - pinhole_of(in).direction); }, 1e-6,
        "with the focus infinitely far away the rays of a film point are parallel");
    return {probe_check("meets_in_focus", "lens_ray", {"uniform_disk"}, rays(camera), {sharp, plane, size, even, ray, purity()}),
            probe_check("focus_at_infinity", "lens_ray", {"uniform_disk"}, rays(distant), {parallel})};
}

}  // namespace grade
