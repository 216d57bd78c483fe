#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/kit/figures.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"

namespace grade {

namespace {

rt::Camera any_pinhole(Generator& random) {
    rt::Camera camera;
    const rt::Frame frame = rt::frame_about(direction(random));
    camera.eye = box(random, -3, 3);
    camera.right = frame.x, camera.up = frame.y, camera.back = frame.z;
    camera.tan_half_fov = between(random, 0.2, 1.2);
    camera.size = {whole_between(random, 20, 400), whole_between(random, 20, 400)};
    return camera;
}

/// The film point that a direction comes from.
rt::vec2 film_point(const rt::Camera& camera, rt::vec3 d) {
    const double forward = -rt::dot(d, camera.back), pixels = camera.size.y / (2 * camera.tan_half_fov);
    return {0.5 * camera.size.x + pixels * rt::dot(d, camera.right) / forward,
            0.5 * camera.size.y - pixels * rt::dot(d, camera.up) / forward};
}

/// The ray to a film point that is another function of the right one.
RowFunction through(std::function<rt::vec2(const rt::Camera&, rt::vec2)> film) {
    return of<rt::Camera, rt::vec2>([=](const rt::Camera& camera, rt::vec2 right) {
        const rt::vec2 p = film(camera, right);
        const double scale = 2 * camera.tan_half_fov / camera.size.y;
        const rt::vec3 d = scale * (p.x - 0.5 * camera.size.x) * camera.right -
                           scale * (p.y - 0.5 * camera.size.y) * camera.up - camera.back;
        return rt::unit(d);
    });
}

}  // namespace

Checks check_camera_ray(Generator& random) {
    const auto inputs = rows_of(64, [](Generator& draw) {
        const rt::Camera camera = any_pinhole(draw);
        return row(camera, square(draw) * rt::vec2(camera.size));
    });
    using rt::Camera, rt::vec2;
    Statistic origin = property("A1", "distance of the origin from the eye",
        [](const Row& in, const Row& out) {
            const rt::vec3 off = from_row<rt::Ray>(out).origin - argument<0, Camera, vec2>(in).eye;
            return rt::largest(off);
        },
        1e-3, "the ray does not start at camera.eye");
    Statistic length = property("A1", "length of the direction, off 1 by",
        [](const Row&, const Row& out) { return std::abs(glm::length(from_row<rt::Ray>(out).direction) - 1); }, 1e-3,
        "the direction is no unit vector");
    Statistic range = property("A1", "the ray's interval",
        [](const Row&, const Row& out) {
            const rt::Ray ray = from_row<rt::Ray>(out);
            return ray.near >= 0 && ray.near < 0.01 && ray.far > 1e6 ? 0.0 : 1.0;
        },
        0, "the ray must be valid from 0 to infinity");

    // first the direction against mistakes that are known, then the film point itself
    const RowFunction right = through([](const Camera&, vec2 p) { return p; });
    Statistic film = formula(
        "A1", "film point of the ray, off by [pixel]", right, 1e-4,
        {{"the picture is upside down: film y runs down, up runs up",
          through([](const Camera& c, vec2 p) { return vec2(p.x, c.size.y - p.y); })},
         {"the picture is mirrored: film x runs to the right",
          through([](const Camera& c, vec2 p) { return vec2(c.size.x - p.x, p.y); })},
         {"the picture is turned by half a turn", through([](const Camera& c, vec2 p) { return vec2(c.size) - p; })},
         {"the ray goes through the centre of the pixel, whatever the film point",
          through([](const Camera&, vec2 p) { return glm::floor(p) + 0.5; })},
         {"the ray goes through the corner of the pixel, whatever the film point",
          through([](const Camera&, vec2 p) { return glm::floor(p); })},
         {"the film point is shifted by half a pixel: it is a point already, no pixel's index",
          through([](const Camera&, vec2 p) { return p + 0.5; })},
         {"the picture is scaled by size - 1; expected size", through([](const Camera& c, vec2 p) {
              return vec2(0.5 * c.size.x, 0.5 * c.size.y) +
                     (vec2(p.x / (c.size.x - 1), p.y / (c.size.y - 1)) - 0.5) * vec2(c.size);
          })},
         {"the picture is scaled by size - 1 and shifted; expected size", through([](const Camera& c, vec2 p) {
              return 0.5 * vec2(c.size) + (p - 0.5 * (vec2(c.size) - 1.0)) * (c.size.y / (c.size.y - 1.0));
          })},
         {"the aspect ratio is missing: x is scaled by the width; expected the height",
          through(
              [](const Camera& c, vec2 p) { return vec2(0.5 * c.size.x + (p.x / c.size.x - 0.5) * c.size.y, p.y); })},
         {"tan_half_fov is that of half the film; the whole film was given it",
          through([](const Camera& c, vec2 p) { return 0.5 * vec2(c.size) + 0.5 * (p - 0.5 * vec2(c.size)); })},
         {"all rays go straight ahead", through([](const Camera& c, vec2) { return 0.5 * vec2(c.size); })},
         {"the camera's axes are not used", of<Camera, vec2>([](const Camera& c, vec2 p) {
              const double s = 2 * c.tan_half_fov / c.size.y;
              return rt::unit(rt::vec3(s * (p.x - 0.5 * c.size.x), s * (0.5 * c.size.y - p.y), -1));
          })}});
    // the outputs start with the origin: compare what follows it
    const auto direction_of = [](Observation seen) {
        for (Row& out : seen.outputs) {
            const rt::vec3 d = rt::unit(from_row<rt::Ray>(out).direction);
            out = row(d);
        }
        return seen;
    };
    film.cause = [cause = film.cause, direction_of](const Observation& seen) { return cause(direction_of(seen)); };
    film.measure = [](const Observation& seen) {
        double worst = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
            const Camera camera = argument<0, Camera, vec2>(seen.inputs[k]);
            const vec2 off = film_point(camera, from_row<rt::Ray>(seen.outputs[k]).direction) -
                             argument<1, Camera, vec2>(seen.inputs[k]);
            const double pixels = std::hypot(off.x, off.y);
            const bool forward = rt::dot(from_row<rt::Ray>(seen.outputs[k]).direction, camera.back) < 0;
            if (!forward) return rt::inf;
            if (!(pixels <= worst)) worst = pixels;
        }
        return worst;
    };
    film.delta = 0.01;
    film.hint = [](double value, double) {
        return fmt::format("the ray misses its film point by up to {:.3g} pixels", value);
    };
    return {probe_check("film_point", inputs, {film, origin, length, range}), slanted_quad(random)};
}

}  // namespace grade
