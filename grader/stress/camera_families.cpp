#include "stress/exact.h"
#include "stress/family.h"

namespace grade {

namespace {

using rt::Camera, rt::Ray, rt::Shutter, rt::vec2, rt::vec3;

/// The slopes of a camera's ray to the right and upwards; axes along the coordinates keep them exact.
double slope_error(const Camera& camera, vec2 film, const Ray& ray) {
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
    std::vector<vec2> films;
    Rows rows;
    while (films.size() < 200) {
        const vec2 u = square(random);
        if (std::min(std::abs(u.x - 0.5), std::abs(u.y - 0.5)) < 0.05) continue;
        films.push_back(u * vec2(camera.size));
        rows.push_back(row(camera, films.back()));
    }
    return worst_of(ask, "camera_ray", rows,
                    [&](std::size_t i, const Row& out) { return slope_error(camera, films[i], from_row<Ray>(out)); });
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
    std::vector<Ray> pinholes;
    Rows rows;
    for (int i = 0; i < 200; ++i) {
        pinholes.push_back({vec3(0), tilted(random, -camera.back, between(random, 0, 0.6)), 0, rt::inf});
        rows.push_back(row(camera, pinholes.back(), square(random)));
    }
    double squares = 0;
    const double worst = worst_of(ask, "lens_ray", rows, [&](std::size_t i, const Row& out) {
        const Ray ray = from_row<Ray>(out);
        squares += dot(ray.origin, ray.origin) / rt::sqr(camera.lens_radius) / double(rows.size());
        if (!(glm::length(ray.origin) <= camera.lens_radius * 1.000001)) return rt::inf;
        Exact3 truth(pinholes[i].direction);
        if (std::isfinite(camera.focus))
            truth = Exact(camera.focus) / -dot(truth, Exact3(camera.back)) * truth - Exact3(ray.origin);
        return apart(unit(truth), ray.direction);
    });
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

/// A shutter that opens so late, for a second: the time since it opened.
double late(double x, Generator& random, const Asker& ask) {
    const Shutter shutter{x, x + 1};
    Rows rows;
    for (int i = 0; i < 200; ++i) rows.push_back(row(shutter, i == 0 ? almost_one : between(random, 0, 1)));
    return worst_of(ask, "shutter_time", rows, [&](std::size_t i, const Row& out) {
        const double u = rows[i].back(), width = shutter.close - shutter.open, since = out.at(0) - shutter.open;
        if (!(out[0] >= shutter.open && out[0] <= shutter.close)) return rt::inf;
        return std::min(std::abs(since - u * width), std::abs(since - (1 - u) * width)) / x;
    });
}

/// A shutter that is open for so short a time, from 0 on.
double brief(double x, Generator& random, const Asker& ask) {
    Rows rows;
    for (int i = 0; i < 200; ++i) rows.push_back(row(Shutter{0, x}, i == 0 ? almost_one : between(random, 0, 1)));
    return worst_of(ask, "shutter_time", rows, [&](std::size_t i, const Row& out) {
        const double u = rows[i].back(), t = out.at(0);
        if (!(t >= 0 && t <= x)) return rt::inf;
        return std::min(std::abs(t - u * x), std::abs(t - (1 - u) * x)) / x;
    });
}

double velocity(double x, Generator& random, const Asker& ask) {
    Rows rows;
    std::vector<std::array<vec3, 2>> moves;
    std::vector<double> times;
    for (int i = 0; i < 200; ++i) {
        moves.push_back({box(random, -1, 1), x * box(random, -1, 1)});
        times.push_back(between(random, 0, 1));
        rows.push_back(row(moves.back()[0], moves.back()[1], times.back()));
    }
    return worst_of(ask, "moved", rows, [&](std::size_t i, const Row& out) {
        return apart(Exact3(moves[i][0]) + Exact(times[i]) * Exact3(moves[i][1]), from_row<vec3>(out)) / (1 + x);
    });
}

}  // namespace

std::vector<Family> camera_families() {
    constexpr double u = rt::roundoff;
    return {
        {"field_of_view",
         {"camera_ray"},
         "tangent of half the field of view",
         "relative error of the slopes",
         1e-5,
         32 * u,
         sweep(-12, 9),
         {-2, 1},
         field_of_view},
        {"image_size",
         {"camera_ray"},
         "size of the image [pixel]",
         "relative error of the slopes",
         1e-5,
         64 * u,
         sweep(0, 9),
         {0, 4},
         image_size},
        {"lens_focus",
         {"lens_ray"},
         "distance of the plane in focus [m]",
         "error of the direction",
         1e-5,
         32 * u,
         sweep(-9, 20, 1, {50, 100, 150, 160, 200, 250, 300}),
         {-1, 3},
         focus},
        {"lens_aperture",
         {"lens_ray"},
         "radius of the lens [m]",
         "error of the direction",
         1e-5,
         32 * u,
         sweep(-20, 9),
         {-3, 0},
         aperture},
        {"shutter_late",
         {"shutter_time"},
         "time when the shutter opens [s]",
         "error of the time / x",
         1e-5,
         8 * u,
         sweep(0, 12),
         {0, 2},
         late},
        {"shutter_brief",
         {"shutter_time"},
         "time that the shutter is open [s]",
         "error of the time / x",
         1e-5,
         8 * u,
         sweep(-60, 0, 3),
         {-3, 0},
         brief},
        {"velocity", {"moved"}, "velocity [m/s]", "error / way", 1e-5, 8 * u, sweep(-12, 20), {-3, 3}, velocity},
    };
}

}  // namespace grade
