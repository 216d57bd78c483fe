#include "asked/camera_ray.h"
#include "asked/lens_ray.h"
#include "asked/moved.h"
#include "asked/shutter_time.h"
#include "stress/exact.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::Camera, rt::Ray, rt::Shutter, rt::vec2, rt::vec3;

/// The slopes of a camera's ray to the right and upwards; axes along the coordinates keep them exact.
double slope_error(const Ray& ray, const Camera& camera, vec2 film) {
    const Exact scale = 2 * Exact(camera.tan_half_fov) / camera.size.y;
    const Exact x = scale * (Exact(film.x) - Exact(camera.size.x) / 2),
                y = scale * (Exact(camera.size.y) / 2 - Exact(film.y));
    const Exact ahead = -Exact(ray.direction.z);
    if (!(ray.direction.z < 0)) return rt::inf;
    const double right = double(abs(Exact(ray.direction.x) / ahead - x) / abs(x)),
                 up = double(abs(Exact(ray.direction.y) / ahead - y) / abs(y));
    return worse_error(worse_error(right, up), std::abs(glm::length(ray.direction) - 1));
}

double error_of_camera(const Camera& camera, Generator& random, const Asker& ask) {
    Rows rows;
    while (rows.size() < 200) {
        const vec2 u = square(random);
        if (std::min(std::abs(u.x - 0.5), std::abs(u.y - 0.5)) < 0.05) continue;
        rows.push_back(row(camera, u * vec2(camera.size)));
    }
    return worst_of<rt::camera_ray>(ask, "camera_ray", rows, slope_error);
}

double field_of_view(double x, Generator& random, const Asker& ask) {
    Camera camera;
    camera.tan_half_fov = x, camera.size = {200, 150};
    return error_of_camera(camera, random, ask);
}

double image_size(double x, Generator& random, const Asker& ask) {
    Camera camera;
    camera.size = {int(x), int(x)};
    return error_of_camera(camera, random, ask);
}

/// Rays of a lens meet the pinhole's ray in the plane in focus: their angle, against the exact one.
double lens(const Camera& camera, Generator& random, const Asker& ask) {
    const Rows rows = rows_of(200, [&](Generator& draw) {
        const Ray pinhole{vec3(0), tilted(draw, -camera.back, between(draw, 0, 0.6)), 0, rt::inf};
        return row(camera, pinhole, square(draw));
    })(random);
    double squares = 0;
    const auto error = [&](const Ray& ray, const Camera&, const Ray& pinhole, vec2) {
        squares += dot(ray.origin, ray.origin) / rt::sqr(camera.lens_radius) / double(rows.size());
        if (!(glm::length(ray.origin) <= camera.lens_radius * 1.000001)) return rt::inf;
        Exact3 truth(pinhole.direction);
        if (std::isfinite(camera.focus))
            truth = Exact(camera.focus) / -dot(truth, Exact3(camera.back)) * truth - Exact3(ray.origin);
        return apart(unit(truth), ray.direction);
    };
    const double worst = worst_of<rt::lens_ray>(ask, "lens_ray", rows, error);
    // the lens is used as a whole
    return std::abs(squares - 0.5) < 0.15 ? worst : rt::inf;
}

double focus(double x, Generator& random, const Asker& ask) {
    Camera camera;
    camera.lens_radius = 0.01, camera.focus = x;
    return lens(camera, random, ask);
}

double aperture(double x, Generator& random, const Asker& ask) {
    Camera camera;
    camera.lens_radius = x, camera.focus = 2;
    return lens(camera, random, ask);
}

/// The error of a shutter's times, of u or of 1 - u as the fragment has it, over x.
double error_of_times(const Shutter& shutter, double x, Generator& random, const Asker& ask) {
    Rows rows;
    for (int i = 0; i < 200; ++i) rows.push_back(row(shutter, i == 0 ? almost_one : between(random, 0, 1)));
    return worst_of<rt::shutter_time>(ask, "shutter_time", rows, [&](double time, const Shutter&, double u) {
        const double width = shutter.close - shutter.open, since = time - shutter.open;
        if (!(time >= shutter.open && time <= shutter.close)) return rt::inf;
        return std::min(std::abs(since - u * width), std::abs(since - (1 - u) * width)) / x;
    });
}

/// A shutter that opens so late, for a second: the time since it opened.
double late(double x, Generator& random, const Asker& ask) { return error_of_times({x, x + 1}, x, random, ask); }

/// A shutter that is open for so short a time, from 0 on.
double brief(double x, Generator& random, const Asker& ask) { return error_of_times({0, x}, x, random, ask); }

double velocity(double x, Generator& random, const Asker& ask) {
    const Rows rows = rows_of(200, [=](Generator& draw) {
        const vec3 point = box(draw, -1, 1), way = x * box(draw, -1, 1);
        return row(point, way, between(draw, 0, 1));
    })(random);
    return worst_of<rt::moved>(ask, "moved", rows, [=](vec3 got, vec3 point, vec3 velocity, double time) {
        return apart(Exact3(point) + Exact(time) * Exact3(velocity), got) / (1 + x);
    });
}

}  // namespace

std::vector<Family> camera_families() {
    constexpr double u = rt::roundoff;
    return {
        Family("field_of_view", {"camera_ray"}, "tangent of half the field of view", "relative error of the slopes",
               {.bound = 32 * u, .decades = sweep(-12, 9), .scored = {-2, 1}}, field_of_view),
        Family("image_size", {"camera_ray"}, "size of the image [pixel]", "relative error of the slopes",
               {.bound = 64 * u, .decades = sweep(0, 9), .scored = {0, 4}}, image_size),
        Family("lens_focus", {"lens_ray"}, "distance of the plane in focus [m]", "error of the direction",
               {.bound = 32 * u, .decades = sweep(-9, 20, 1, {50, 100, 150, 160, 200, 250, 300}), .scored = {-1, 3}},
               focus),
        Family("lens_aperture", {"lens_ray"}, "radius of the lens [m]", "error of the direction",
               {.bound = 32 * u, .decades = sweep(-20, 9), .scored = {-3, 0}}, aperture),
        Family("shutter_late", {"shutter_time"}, "time when the shutter opens [s]", "error of the time / x",
               {.bound = 8 * u, .decades = sweep(0, 12), .scored = {0, 2}}, late),
        Family("shutter_brief", {"shutter_time"}, "time that the shutter is open [s]", "error of the time / x",
               {.bound = 8 * u, .decades = sweep(-60, 0, 3), .scored = {-3, 0}}, brief),
        Family("velocity", {"moved"}, "velocity [m/s]", "error / way", {.bound = 8 * u, .decades = sweep(-12, 20)},
               velocity)};
}

}  // namespace grade::stress
