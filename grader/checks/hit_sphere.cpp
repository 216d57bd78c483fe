#include "asked/hit_sphere.h"
#include "checks/kit/figures.h"
#include "checks/kit/kit.h"

namespace grade {

namespace {

using rt::Ray, rt::Sphere;

/// The two parameters at which the line of a ray is on the sphere; nan where it passes by. From the foot of the
/// perpendicular and Pythagoras, in long double.
std::array<double, 2> crossings(const Sphere& sphere, const Ray& ray) {
    using Long = glm::vec<3, long double>;
    const Long d(ray.direction), f = Long(sphere.center) - Long(ray.origin);
    const long double length2 = glm::dot(d, d), foot = glm::dot(f, d) / length2;
    const Long beside = f - foot * d;
    const long double half =
        std::sqrt(((long double)sphere.radius * sphere.radius - glm::dot(beside, beside)) / length2);
    return {double(foot - half), double(foot + half)};
}

using Allowed = bool (*)(double t, const Ray& ray);

/// The first crossing that is allowed, or inf.
auto first(Allowed near_one, Allowed far_one) {
    return [=](const Sphere& sphere, const Ray& ray) {
        const auto [t0, t1] = crossings(sphere, ray);
        return near_one(t0, ray) ? t0 : far_one(t1, ray) ? t1 : rt::inf;
    };
}

/// The first crossing in the interval, with 1 in place of d . d: as books have it for directions of length 1, as the
/// nearest point of the ray gives it, and as the header of the fragment has it.
enum class Way { textbook, nearest_point, header };

auto with_unit_direction(Way way) {
    return [way](const Sphere& sphere, const Ray& ray) {
        const rt::vec3 f = ray.origin - sphere.center;
        const double b = -rt::dot(f, ray.direction), radius2 = sphere.radius * sphere.radius;
        const double c = rt::dot(f, f) - radius2;
        const rt::vec3 nearest = f + b * ray.direction;
        const double half = std::sqrt(way == Way::textbook ? b * b - c : radius2 - rt::dot(nearest, nearest));
        const double q = b + std::copysign(half, b);
        const auto [low, high] = way == Way::header ? std::minmax({c / q, q}) : std::minmax({b - half, b + half});
        return low > ray.near && low < ray.far ? low : high > ray.near && high < ray.far ? high : rt::inf;
    };
}

/// A sphere, and a ray that meets its line well, from outside, inside or behind, with an interval that holds both, one
/// or none of the crossings. Nothing of the interval within a hundredth of a decision; some rays pass close to the rim,
/// on either side: a fault there is seen in few pixels.
Row ordinary_sphere(Generator& random, bool clipped) {
    // one extreme at a time, so that each seed asks for the same
    enum Extreme { none, any_size, far, any_speed };
    const int which = whole_between(random, 0, 7);
    const Sphere sphere{chance(random, 0.1) ? rt::vec3(0) : box(random, -5, 5),
                        which == any_size ? range_between(random, 1e-3, 1e3) : log_between(random, 0.1, 10)};
    const rt::vec3 d = scene_direction(random);
    const bool at_rim = chance(random, 0.35);
    const double passing = at_rim                ? 1 + close_to_zero(random, 1e-6)
                           : chance(random, 0.2) ? between(random, 1.1, 2)
                                                 : angle_from_axis(random, 0.95);
    const rt::vec3 beside = passing * sphere.radius * tilted(random, d, rt::pi / 2);
    const double start = which == far          ? -range_between(random, 30, 1000)
                         : chance(random, 0.3) ? between(random, -0.1, 0.1)
                                               : between(random, -30, 8);
    const double usual = chance(random, 0.3) ? 1 : log_between(random, 0.1, 10);
    const double speed = which == any_speed ? range_between(random, 1e-3, 1e3) : usual;  // |direction|

    Ray ray{sphere.center + beside + start * sphere.radius * d, speed * d, 0, rt::inf};
    const auto [t0, t1] = crossings(sphere, ray);
    if (std::isfinite(t0)) {
        const double margin = 0.02 * (t1 - t0);
        if (std::abs(t0) < margin || std::abs(t1) < margin) return ordinary_sphere(random, clipped);
        const double nears[] = {between(random, 0.6, 0.9) * t0, (t0 + t1) / 2, t1 + (t1 - t0)};
        if (clipped && chance(random, 0.6)) ray.near = std::max(0.0, nears[whole_between(random, 0, 2)]);
        if (clipped && chance(random, 0.5)) ray.far = std::max(ray.near, 0.0) + std::abs(t1) * between(random, 0.1, 2);
        for (const double t : {t0, t1})
            if (std::abs(t - ray.near) < margin || std::abs(t - ray.far) < margin)
                return ordinary_sphere(random, clipped);
    }
    return row(sphere, ray);
}

/// A ray towards a sphere or away from it, or from within, whose interval begins and ends anywhere: before the near
/// crossing, between it and the foot of the perpendicular, between that and the far crossing, or behind.
///
/// begins, ends  which of these four
Row interval_in_order(Generator& random, int begins, int ends) {
    const Sphere sphere{box(random, -5, 5), log_between(random, 0.1, 10)};
    const rt::vec3 d = scene_direction(random);
    const rt::vec3 beside = between(random, 0.05, 0.9) * sphere.radius * tilted(random, d, rt::pi / 2);
    Ray ray{sphere.center + beside - between(random, 2, 6) * sphere.radius * d, log_between(random, 0.3, 3) * d};
    const auto [t0, t1] = crossings(sphere, ray);
    const double foot = (t0 + t1) / 2, bounds[] = {t0 - (t1 - t0), t0, foot, t1, t1 + (t1 - t0)};
    const auto in = [&](int part, double low, double high) {
        return bounds[part] + between(random, low, high) * (bounds[part + 1] - bounds[part]);
    };
    ray.near = std::max(0.0, in(begins, 0.1, begins == ends ? 0.45 : 0.9));
    ray.far = in(ends, begins == ends ? 0.55 : 0.1, 0.9);
    // t counts from the origin: now and then that lies where the interval begins
    if (chance(random, 0.3)) ray.origin += ray.near * ray.direction, ray.far -= ray.near, ray.near = 0;
    return row(sphere, ray);
}

/// All orders, some of each.
Rows intervals_in_order(Generator& random) {
    Rows rows;
    for (int begins = 0; begins < 4; ++begins)
        for (int ends = begins; ends < 4; ++ends)
            for (int k = 0; k < 3; ++k) rows.push_back(interval_in_order(random, begins, ends));
    return rows;
}

/// A small sphere that is met or missed by a hair: single precision, metres from the origin, does not know which.
Row fine_sphere(Generator& random) {
    const Sphere sphere{box(random, -5, 5), log_between(random, 1e-3, 1e-2)};
    const double hair = (chance(random, 0.5) ? 1 : -1) * log_between(random, 1e-6, 1e-5);
    const rt::vec3 d = direction(random), beside = (1 + hair) * sphere.radius * tilted(random, d, rt::pi / 2);
    return row(sphere, Ray{sphere.center + beside - between(random, 20, 1000) * sphere.radius * d, d, 0, rt::inf});
}

/// A sphere a millimetre large, and a ray that starts close by, or within it.
Row small_sphere(Generator& random) {
    const double radius = log_between(random, 1e-3, 1e-2);
    const Sphere sphere{radius * box(random, -2, 2), radius};
    const rt::vec3 d = direction(random), beside = between(random, 0, 0.9) * radius * tilted(random, d, rt::pi / 2);
    const double start = chance(random, 0.3) ? between(random, -0.3, 0.3) : -1 - log_between(random, 0.02, 3);
    return row(sphere, Ray{sphere.center + beside + start * radius * d, log_between(random, 0.5, 10) * d, 0, rt::inf});
}

Check silhouette(Generator& random) {
    const Place place = any_place(random);
    const rt::vec3 center = place({between(random, -0.5, 0.5), between(random, -0.4, 0.4), 0});
    const double radius = between(random, 0.7, 1.1);
    return figure_check(
        "silhouette", toml(place.from_above(5, 40, figure_size)) + bright_lamp() + sphere("lamp", center, radius),
        "sphere", [=](const rt::Camera& camera) -> Sight {
            return [=](rt::vec2 film) {
                return glm::length(rt::cross(center - camera.eye, view_direction(camera, film))) < radius ? 1.0 : 0.0;
            };
        });
}

constexpr const char* length_forgotten =
    "d . d is left out, as if the direction had length 1: it may have any, and t counts in units of |d|";

Statistic distance_to_sphere(const std::string& what) {
    const Allowed inside = [](double t, const Ray& ray) { return t > ray.near && t < ray.far; };
    const Allowed after_start = [](double t, const Ray&) { return t > 0; };
    const Allowed anywhere = [](double t, const Ray&) { return !std::isnan(t); };
    const Allowed never = [](double, const Ray&) { return false; };
    const Allowed before_far = [](double t, const Ray& ray) { return t > 0 && t < ray.far; };
    const Allowed after_near = [](double t, const Ray& ray) { return t > ray.near; };
    const Allowed as_length = [](double t, const Ray& ray) {
        const double way = t * glm::length(ray.direction);
        return way > ray.near && way < ray.far;
    };
    return formula<rt::hit_sphere>(
        {.id = "W1",
         .what = what,
         .tolerance = 1e-3,
         .right = first(inside, inside),
         .suspects =
             {{length_forgotten, with_unit_direction(Way::textbook)},
              {length_forgotten, with_unit_direction(Way::nearest_point)},
              {length_forgotten, with_unit_direction(Way::header)},
              {"the far crossing is returned where the near one counts", first(never, inside)},
              {"crossings behind the ray's origin count as hits", first(anywhere, anywhere)},
              {"the far crossing is never returned: a ray that starts inside must hit the sphere from within",
               first(inside, never)},
              {"the ray's interval is ignored: a hit counts only for near < t < far", first(after_start, after_start)},
              {"the ends of the ray's interval are compared with a length; expected with t, in units of |direction|",
               first(as_length, as_length)},
              {"the near end of the ray's interval is ignored", first(before_far, before_far)},
              {"the far end of the ray's interval is ignored", first(after_near, after_near)},
              {"t is a length; expected in units of |direction|, which need not be 1",
               [](double right, const Sphere&, const Ray& r) { return right * glm::length(r.direction); }},
              {"a sphere that is missed gives no inf",
               [](double right, const Sphere& s, const Ray& r) {
                   return std::isnan(crossings(s, r)[0]) ? double(NAN) : right;
               }}},
         .circumstances = {{"only rays whose direction is no unit vector are wrong: d . d is not 1",
                            [](const Sphere&, const Ray& r) { return std::abs(glm::length(r.direction) - 1) > 1e-6; }},
                           {"only rays that start inside the sphere are wrong",
                            [](const Sphere& s, const Ray& r) { return glm::length(r.origin - s.center) < s.radius; }},
                           {"only rays that pass the sphere are wrong: the square root's argument is negative there",
                            [](const Sphere& s, const Ray& r) { return std::isnan(crossings(s, r)[0]); }}}});
}

}  // namespace

Checks check_hit_sphere(Generator& random) {
    const auto unclipped = rows_of(128, [](Generator& draw) { return ordinary_sphere(draw, false); });
    const auto clipped = rows_of(96, [](Generator& draw) { return ordinary_sphere(draw, true); });
    const auto from_center = rows_of(8, [](Generator& draw) {
        const Sphere sphere{box(draw, -5, 5), log_between(draw, 0.1, 10)};
        return row(sphere, Ray{sphere.center, log_between(draw, 0.3, 3) * scene_direction(draw), 0, rt::inf});
    });
    // exactly at a crossing the interval is open
    const auto at_ends = rows_of(16, [](Generator& draw) {
        const double size = std::exp2(whole_between(draw, -3, 3));
        const Sphere sphere{size * rt::vec3(whole_between(draw, -4, 4), whole_between(draw, -4, 4), 1), size};
        const rt::vec3 d = exact_direction(draw);
        Ray ray{sphere.center - 2 * size * d, d, 0, rt::inf};
        (chance(draw, 0.5) ? ray.near : ray.far) = chance(draw, 0.5) ? size : 3 * size;
        return row(sphere, ray);
    });
    return {probe_check("nearest_crossing", rows_then(unclipped, rows_then(rows_of(32, fine_sphere), from_center)),
                        {distance_to_sphere("distance, off by")}),
            probe_check("small_spheres", rows_of(96, small_sphere),
                        {distance_to_sphere("distance to a small sphere, off by")}),
            probe_check("interval", rows_then(rows_then(clipped, intervals_in_order), at_ends),
                        {distance_to_sphere("distance within the interval, off by")}),
            silhouette(random)};
}

}  // namespace grade
