#pragma once

#include "checks/kit/kit.h"

/// Triangles and quads are hit where a plane is hit, and where weights say that the point is inside.
namespace grade {

/// A ray towards a point, from either side, and an interval that holds the point, or ends before it, or starts behind
/// it.
inline rt::Ray ray_towards(Generator& random, rt::vec3 target, rt::vec3 normal, double size, bool clipped) {
    // one extreme at a time, so that each seed asks for the same
    enum Extreme { size_alone, grazing, far, any_speed };
    const int which = size < 0.01 || size > 10 ? size_alone : whole_between(random, 0, 7);
    const double angle = which == grazing ? std::acos(log_between(random, 2e-3, 0.1)) : angle_from_axis(random, 1.3);
    const rt::vec3 d = tilted(random, (chance(random, 0.5) ? 1.0 : -1.0) * normal, angle);
    const double away = which == far ? range_between(random, 20, 1000) : between(random, 0.5, 20);
    const double distance = size * away * (chance(random, 0.85) ? 1 : -1);
    const double usual = chance(random, 0.3) ? 1 : log_between(random, 0.3, 10);
    const double speed = which == any_speed ? range_between(random, 1e-3, 1e3) : usual;
    rt::Ray ray{target - distance * d, speed * d, 0, rt::inf};
    if (clipped && chance(random, 0.6)) ray.near = std::abs(distance) / speed * between(random, 0.2, 1.8);
    if (clipped && chance(random, 0.6)) ray.far = ray.near + std::abs(distance) / speed * between(random, 0.2, 1.8);
    const double t = distance / speed;
    const bool close = std::abs(t - ray.near) < 0.05 * std::abs(t) || std::abs(t - ray.far) < 0.05 * std::abs(t);
    return close ? ray_towards(random, target, normal, size, clipped) : ray;
}

/// How large a shape is, or what of it: mostly as things in a room are, and down and up to what is promised.
inline double scene_size(Generator& random) {
    return chance(random, 0.7) ? log_between(random, 0.01, 10) : range_between(random, 1e-3, 1e3);
}

/// How far a point is from a rim, in sizes, on either side: so close that single precision, some metres from the
/// origin, does not know the side. Each seed has enough of them.
inline double hair(Generator& random) { return (chance(random, 0.5) ? 1 : -1) * log_between(random, 1e-6, 1e-5); }

/// A ray to such a point, from so far away that single precision does not know the side either by the way that is left.
inline rt::Ray ray_from_afar(Generator& random, rt::vec3 target, rt::vec3 normal, double size) {
    const rt::vec3 d = tilted(random, normal, between(random, 0, 1.2));
    return {target - between(random, 20, 1000) * size * d, d, 0, rt::inf};
}

/// Small shapes: any, the smallest met by the slowest ray at a grazing angle, or that met by the fastest ray from close
/// by. An absolute epsilon that is too large for these fails under each seed, one that is not, under none.
enum class Small { any, least, closest };
inline double small_size(Generator& random, Small which) {
    return which == Small::any ? log_between(random, 5e-4, 5e-3) : 6e-4;
}

/// A ray that starts within a few sizes of its target.
inline rt::Ray near_ray(Generator& random, rt::vec3 target, rt::vec3 normal, double size, Small which) {
    const bool is_least = which == Small::least;
    const double angle = is_least ? std::acos(between(random, 0.03, 0.05)) : between(random, 0, 1.3);
    const rt::vec3 d = tilted(random, (chance(random, 0.5) ? 1.0 : -1.0) * normal, angle);
    const bool is_close = which == Small::closest;
    const double distance = size * (is_close ? 0.05 : log_between(random, 0.05, 3));
    const double any_speed = log_between(random, 1e-3, 10), speed = is_least ? 1e-3 : is_close ? 10 : any_speed;
    return {target - distance * d, speed * d, 0, rt::inf};
}

/// Three axes of the world in any order and of either sign, all as long as one power of two: what is computed of them,
/// of whole multiples and of quarters is not rounded.
struct ExactFrame {
    rt::vec3 x{0}, y{0}, z{0}, corner;
};
inline ExactFrame exact_frame(Generator& random) {
    const double size = std::exp2(whole_between(random, -6, 3));
    const int x = whole_between(random, 0, 2), y = (x + whole_between(random, 1, 2)) % 3;
    ExactFrame frame;
    frame.x[x] = chance(random, 0.5) ? size : -size;
    frame.y[y] = chance(random, 0.5) ? size : -size;
    frame.z[3 - x - y] = chance(random, 0.5) ? size : -size;
    for (int k = 0; k < 3; ++k) frame.corner[k] = size * whole_between(random, -4, 4);
    return frame;
}

/// A ray straight down to a point, whose t is exact; now and then one of its ends, which do not count.
inline rt::Ray exact_ray(Generator& random, rt::vec3 target, const ExactFrame& frame) {
    const double away = whole_between(random, 1, 8), speed = std::exp2(whole_between(random, -2, 2));
    rt::Ray ray{target + away * frame.z, -speed * frame.z, 0, rt::inf};
    const int end = whole_between(random, 0, 5);
    if (end == 0) ray.near = away / speed;
    if (end == 1) ray.far = away / speed;
    return ray;
}

/// Where the ray's line meets a plane.
inline double plane_crossing(const rt::Ray& ray, rt::vec3 point, rt::vec3 normal) {
    return rt::dot(point - ray.origin, normal) / rt::dot(ray.direction, normal);
}

/// A flat shape, by its normal, and by whether the point where a ray's line meets its plane is inside, as its rim is.
template <class Shape>
struct FlatShape {
    std::function<rt::vec3(const Shape&)> point, normal, product;  // of two edges
    std::function<bool(const Shape&, const rt::Ray&)> inside, on_rim;
    std::function<double(const Shape&)> size;

    double crossing(const Shape& s, const rt::Ray& ray) const { return plane_crossing(ray, point(s), normal(s)); }
};

inline bool in_interval(const rt::Ray& ray, double t) { return t > ray.near && t < ray.far; }

/// The answer for a shape that is hit where `inside` says so, and allowed(ray, t).
template <class Shape, class Inside, class Allowed>
auto hit_where(const FlatShape<Shape>& flat, Inside inside, Allowed allowed) {
    return [=](const Shape& s, const rt::Ray& ray) {
        const double t = flat.crossing(s, ray);
        return inside(s, ray) && allowed(ray, t) ? t : rt::inf;
    };
}

/// Mistakes at any flat shape.
template <auto fragment, class Shape>
std::vector<Suspect<fragment>> flat_suspects(const FlatShape<Shape>& flat) {
    const auto when = [=](auto allowed) { return hit_where(flat, flat.inside, allowed); };
    const auto on_side = [normal = flat.normal](double side) {
        return [=](double right, const Shape& s, const rt::Ray& ray) {
            return side * rt::dot(ray.direction, normal(s)) > 0 ? right : rt::inf;
        };
    };
    const auto within_rim = [=](const Shape& s, const rt::Ray& ray) {
        return flat.inside(s, ray) && !flat.on_rim(s, ray);
    };
    // t as it is before it is divided by dot(n, direction)
    const auto undivided = [=](auto n) {
        return [=](const Shape& s, const rt::Ray& ray) {
            const double t = flat.crossing(s, ray), whole = t * std::abs(rt::dot(n(s), ray.direction));
            return flat.inside(s, ray) && in_interval(ray, whole) ? t : rt::inf;
        };
    };
    using rt::Ray;
    return {
        {"a ray that meets an edge or a corner exactly is a miss: it must hit, or neighbours have a gap between them",
         hit_where(flat, within_rim, in_interval)},
        {"the back side is never hit: a shape is hit from either side", on_side(-1)},
        {"the front side is never hit: a shape is hit from either side", on_side(1)},
        {"hits behind the ray's origin count", when([](const Ray&, double) { return true; })},
        {"the ray's interval is ignored: a hit counts only for near < t < far",
         when([](const Ray&, double t) { return t > 0; })},
        {"the near end of the ray's interval is ignored",
         when([](const Ray& r, double t) { return t > 0 && t < r.far; })},
        {"the far end of the ray's interval is ignored", when([](const Ray& r, double t) { return t > r.near; })},
        {"the ends of the ray's interval are compared with a length; expected with t, in units of |direction|",
         when([](const Ray& r, double t) { return in_interval(r, t * glm::length(r.direction)); })},
        {"near and far are compared with t before it is divided; expected after that", undivided(flat.product)},
        {"near and far are compared with the distance from the plane; expected with t = that over dot(n, direction)",
         undivided(flat.normal)},
        {"the whole plane is hit, not the shape alone",
         hit_where(
             flat, [](const Shape&, const Ray&) { return true; }, in_interval)},
        {"t is a length; expected in units of |direction|, which need not be 1",
         [](double right, const Shape&, const Ray& r) { return right * glm::length(r.direction); }}};
}

/// The checks of a flat shape: distances of whole rays, and within their intervals.
///
/// draw(random, clipped)  a row
/// fine(random)           one of a small shape that is met a hair from its rim
/// rim(random)            one that meets the rim exactly: it counts, or a gap is left between neighbours
/// small(random, which)   one of a shape a millimetre large, close by; or of a ray that runs along its plane
template <auto fragment, class Shape>
Checks flat_checks(const FlatShape<Shape>& flat, const std::vector<Suspect<fragment>>& suspects,
                   Row (*draw)(Generator&, bool clipped), Row (*fine)(Generator&), Row (*rim)(Generator&),
                   Row (*small)(Generator&, Small)) {
    const auto distance = [&](const std::string& what) {
        return formula<fragment>(
            {.id = "W1",
             .what = what,
             .tolerance = 1e-3,
             .right = hit_where(flat, flat.inside, in_interval),
             .suspects = suspects,
             .circumstances = {
                 {"only rays whose direction is no unit vector are wrong: t is in units of |direction|",
                  [](const Shape&, const rt::Ray& r) { return std::abs(glm::length(r.direction) - 1) > 1e-6; }},
                 {"only small shapes are wrong: an absolute epsilon is too large for them",
                  [size = flat.size](const Shape& s, const rt::Ray&) { return size(s) < 0.2; }}}});
    };
    const auto ordinary = [=](Generator& random) { return draw(random, false); };
    const auto any_small = [=](Generator& random) { return small(random, Small::any); };
    const auto least = [=](Generator& random) { return small(random, Small::least); };
    const auto closest = [=](Generator& random) { return small(random, Small::closest); };
    const auto inside = rows_then(rows_then(rows_of(128, ordinary), rows_of(32, fine)), rows_of(24, rim));
    return {probe_check("inside", inside, {distance("distance, off by")}),
            probe_check("small_and_edge_on", rows_then(rows_of(96, any_small), rows_of_kinds(4, least, closest)),
                        {distance("distance to a small shape, off by")}),
            probe_check("interval", rows_of(160, [=](Generator& random) { return draw(random, true); }),
                        {distance("distance within the interval, off by")})};
}

}  // namespace grade
