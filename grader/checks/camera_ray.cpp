#include "asked/camera_ray.h"
#include "checks/kit/figures.h"
#include "checks/kit/kit.h"

namespace grade {

namespace {

using rt::Camera, rt::Ray, rt::vec2, rt::vec3;

Camera any_pinhole(Generator& random) {
    Camera camera;
    const rt::Frame frame = rt::frame_about(scene_direction(random));
    camera.eye = box(random, -3, 3);
    camera.right = frame.x, camera.up = frame.y, camera.back = frame.z;
    camera.tan_half_fov = chance(random, 0.75) ? between(random, 0.2, 1.2) : log_between(random, 0.01, 10);
    camera.size = {whole_between(random, 20, 400), whole_between(random, 20, 400)};
    if (chance(random, 0.5)) camera.focus = log_between(random, 0.1, 100);  // no matter without a lens
    return camera;
}

/// How far the film point that a direction comes from is off.
double pixels_off(const Ray& ray, const Camera& camera, vec2 film) {
    const vec3 d = ray.direction;
    const double forward = -rt::dot(d, camera.back), pixels = camera.size.y / (2 * camera.tan_half_fov);
    const vec2 point(0.5 * camera.size.x + pixels * rt::dot(d, camera.right) / forward,
                     0.5 * camera.size.y - pixels * rt::dot(d, camera.up) / forward);
    const vec2 off = point - film;
    return rt::dot(d, camera.back) < 0 ? std::hypot(off.x, off.y) : rt::inf;
}

/// The direction to a film point that is another function of the right one.
template <class Film>
RowFunction through(Film film) {
    return answer<rt::camera_ray>([=](const Camera& c, vec2 p) { return view_direction(c, film(c, p)); });
}

/// The film point of a ray. Mistakes are told by the direction alone, whatever the origin.
Statistic film_point() {
    const auto suspect = [](const char* words, auto film) {
        return RowSuspect{words, [outputs = through(film)](const Row& in, const Row&) { return outputs(in); }};
    };
    const auto middle = [](const Camera& c) { return 0.5 * vec2(c.size); };
    const Statistic directions = formula(RowFormula{
        .tolerance = 1e-4,
        .right = through([](const Camera&, vec2 p) { return p; }),
        .suspects = {
            suspect("the picture is upside down: film y runs down, up runs up",
                    [](const Camera& c, vec2 p) { return vec2(p.x, c.size.y - p.y); }),
            suspect("the picture is mirrored: film x runs to the right",
                    [](const Camera& c, vec2 p) { return vec2(c.size.x - p.x, p.y); }),
            suspect("the picture is turned by half a turn", [](const Camera& c, vec2 p) { return vec2(c.size) - p; }),
            suspect("the ray goes through the centre of the pixel, whatever the film point",
                    [](const Camera&, vec2 p) { return glm::floor(p) + 0.5; }),
            suspect("the ray goes through the corner of the pixel, whatever the film point",
                    [](const Camera&, vec2 p) { return glm::floor(p); }),
            suspect("the film point is shifted by half a pixel: it is a point already, no pixel's index",
                    [](const Camera&, vec2 p) { return p + 0.5; }),
            suspect(
                "the picture is scaled by size - 1; expected size",
                [=](const Camera& c, vec2 p) { return middle(c) + (p / (vec2(c.size) - 1.0) - 0.5) * vec2(c.size); }),
            suspect("the picture is scaled by size - 1 and shifted; expected size",
                    [=](const Camera& c, vec2 p) {
                        return middle(c) + (p - 0.5 * (vec2(c.size) - 1.0)) * (c.size.y / (c.size.y - 1.0));
                    }),
            suspect(
                "the aspect ratio is missing: x is scaled by the width; expected the height",
                [=](const Camera& c, vec2 p) { return vec2(0.5 * c.size.x + (p.x / c.size.x - 0.5) * c.size.y, p.y); }),
            suspect("tan_half_fov is that of half the film; the whole film was given it",
                    [=](const Camera& c, vec2 p) { return middle(c) + 0.5 * (p - middle(c)); }),
            suspect("all rays go straight ahead", [=](const Camera& c, vec2) { return middle(c); }),
            {"the camera's axes are not used", [](const Row& in, const Row&) {
                 Camera upright = argument<rt::camera_ray, 0>(in);
                 upright.right = {1, 0, 0}, upright.up = {0, 1, 0}, upright.back = {0, 0, 1};
                 return row(view_direction(upright, argument<rt::camera_ray, 1>(in)));
             }}}});
    return {.id = "A1",
            .what = "film point of the ray, off by [pixel]",
            .measure = property({.violation = of_call<rt::camera_ray>(pixels_off)}).measure,
            .truth = 0,
            .delta = 0.01,
            .exact = true,
            .hint = with_value("the ray misses its film point by up to {:.3g} pixels"),
            .cause = [cause = directions.cause](Observation seen) {
                for (Row& out : seen.outputs) out = row(vec3(rt::unit(result<rt::camera_ray>(out).direction)));
                return cause(seen);
            }};
}

}  // namespace

Checks check_camera_ray(Generator& random) {
    const auto inputs = rows_of(64, [](Generator& draw) {
        const Camera camera = any_pinhole(draw);
        return row(camera, square(draw) * vec2(camera.size));
    });
    const Statistic origin =
        property({.id = "A1",
                  .what = "distance of the origin from the eye",
                  .violation = of_call<rt::camera_ray>(
                      [](const Ray& ray, const Camera& camera, vec2) { return rt::largest(ray.origin - camera.eye); }),
                  .tolerance = 1e-3,
                  .says = "the ray does not start at camera.eye"});
    return {probe_check(
                "film_point", inputs,
                {film_point(), origin, unit_direction<rt::camera_ray>("A1", 1e-3), whole_ray<rt::camera_ray>("A1")}),
            slanted_quad(random)};
}

}  // namespace grade
