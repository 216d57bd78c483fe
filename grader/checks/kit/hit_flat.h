#pragma once

#include "checks/kit/draw.h"
#include "checks/kit/formula.h"

/// Triangles and quads are hit where a plane is hit, and where weights say that the point is inside.
namespace grade {

/// A ray towards a point, from either side, and an interval that holds the point, or ends before it, or starts behind
/// it.
inline rt::Ray ray_towards(Generator& random, rt::vec3 target, rt::vec3 normal, double size, bool clipped) {
    const rt::vec3 d = tilted(random, (chance(random, 0.5) ? 1.0 : -1.0) * normal, between(random, 0, 1.3));
    const double distance = size * between(random, 0.5, 20) * (chance(random, 0.85) ? 1 : -1);
    const double speed = chance(random, 0.3) ? 1 : log_between(random, 0.3, 10);
    rt::Ray ray{target - distance * d, speed * d, 0, rt::inf};
    if (clipped && chance(random, 0.6)) ray.near = std::abs(distance) / speed * between(random, 0.2, 1.8);
    if (clipped && chance(random, 0.6)) ray.far = ray.near + std::abs(distance) / speed * between(random, 0.2, 1.8);
    const double t = distance / speed;
    const bool close = std::abs(t - ray.near) < 0.05 * std::abs(t) || std::abs(t - ray.far) < 0.05 * std::abs(t);
    return close ? ray_towards(random, target, normal, size, clipped) : ray;
}

/// Where the ray's line meets a plane.
inline double plane_crossing(const rt::Ray& ray, rt::vec3 point, rt::vec3 normal) {
    return rt::dot(point - ray.origin, normal) / rt::dot(ray.direction, normal);
}

/// Mistakes at any flat shape; t is where the line meets the plane, and whether the point is inside.
template <class Shape>
std::vector<Suspect> flat_suspects(std::function<double(const Shape&, const rt::Ray&)> t,
                                   std::function<bool(const Shape&, const rt::Ray&)> inside,
                                   std::function<rt::vec3(const Shape&)> normal) {
    const auto when = [=](auto allowed) {
        return of<Shape, rt::Ray>([=](const Shape& shape, const rt::Ray& ray) {
            return inside(shape, ray) && allowed(shape, ray, t(shape, ray)) ? t(shape, ray) : rt::inf;
        });
    };
    const auto in_range = [](const rt::Ray& ray, double at) { return at > ray.near && at < ray.far; };
    return {{"the back side is never hit: a shape is hit from either side",
             when([=](const Shape& s, const rt::Ray& r, double at) {
                 return in_range(r, at) && rt::dot(r.direction, normal(s)) < 0;
             })},
            {"the front side is never hit: a shape is hit from either side",
             when([=](const Shape& s, const rt::Ray& r, double at) {
                 return in_range(r, at) && rt::dot(r.direction, normal(s)) > 0;
             })},
            {"hits behind the ray's origin count", when([](const Shape&, const rt::Ray&, double) { return true; })},
            {"the ray's interval is ignored: a hit counts only for near < t < far",
             when([](const Shape&, const rt::Ray&, double at) { return at > 0; })},
            {"the near end of the ray's interval is ignored",
             when([](const Shape&, const rt::Ray& r, double at) { return at > 0 && at < r.far; })},
            {"the far end of the ray's interval is ignored",
             when([](const Shape&, const rt::Ray& r, double at) { return at > r.near; })},
            {"the whole plane is hit, not the shape alone", of<Shape, rt::Ray>([=](const Shape& s, const rt::Ray& r) {
                 return in_range(r, t(s, r)) ? t(s, r) : rt::inf;
             })},
            {"t is a length; expected in units of |direction|, which need not be 1",
             of<Shape, rt::Ray>([=](const Shape& s, const rt::Ray& r) {
                 return inside(s, r) && in_range(r, t(s, r)) ? t(s, r) * glm::length(r.direction) : rt::inf;
             })}};
}

/// Where a flat shape is wrong; size is that of the shape.
template <class Shape>
std::vector<Circumstance> flat_circumstances(std::function<double(const Shape&)> size) {
    return {{"only rays whose direction is no unit vector are wrong: t is in units of |direction|", [](const Row& in) {
                 const rt::Ray ray = argument<1, Shape, rt::Ray>(in);
                 return std::abs(glm::length(ray.direction) - 1) > 1e-6;
             }},
            {"only small shapes are wrong: an absolute epsilon is too large for them", [size](const Row& in) {
                 return size(argument<0, Shape, rt::Ray>(in)) < 0.2;
             }}};
}

}  // namespace grade
