#pragma once

#include "rt/answers.h"
#include "rt/elementary.h"

/// Sampling quads by the solid angle that they fill, in place of their area: no noise from distance and angle at the
/// lamp. Nobody needs this file for the assignment.
///
/// Source: Ureña, Fajardo, King, "An Area-Preserving Parametrization for Spherical Rectangles", EGSR 2013.
namespace rt {

/// A quad as seen from a point in front of it. Coordinates run from the point along the edges and towards the plane.
struct SeenQuad {
    vec3 x, y, normal;    // unit [world]
    Real x0, x1, y0, y1;  // of the edges [m]
    Real height;          // of the point over the plane; negative behind it [m]
    vec2 left;            // (cos, sin) of the sum of the angles of the corners at x0
    Real solid_angle;     // [sr]; meaningless behind the quad

    /// Below this solid angle the corners' angles cancel, and a point of the area is as good: distance and angle hardly
    /// vary.
    static constexpr Real least = 1e-3;

    /// Whether sample_by_angle has digits enough: not from afar, nor from a point that touches the quad.
    bool is_wide() const { return bool(1e9 * height > (x1 - x0) + (y1 - y0)) & bool(solid_angle > least); }
};

/// The product of complex numbers: angles are added.
[[gnu::always_inline]] inline vec2 turned(vec2 a, vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

/// The solid angle is the sum of atan(x y / (z r)) over the corners, r the distance of each, with alternating signs:
/// the angle of a product of complex numbers.
[[gnu::always_inline]] inline SeenQuad seen_from(const Quad& quad, vec3 p) {
    const Real half_width = std::sqrt(dot(quad.u, quad.u)), half_height = std::sqrt(dot(quad.v, quad.v));
    SeenQuad seen;
    seen.x = quad.u * (1 / half_width), seen.y = quad.v * (1 / half_height), seen.normal = cross(seen.x, seen.y);
    const vec3 to_center = quad.center - p;
    const Real x = dot(to_center, seen.x), y = dot(to_center, seen.y), z = -dot(to_center, seen.normal);
    const Real x0 = x - half_width, x1 = x + half_width, y0 = y - half_height, y1 = y + half_height;
    const auto corner = [=](Real cx, Real cy) { return vec2(z * std::sqrt(cx * cx + cy * cy + z * z), cx * cy); };
    const auto against = [](vec2 a) { return vec2(a.x, -a.y); };
    const auto of_length_1 = [](vec2 a) { return a * (1 / std::sqrt(dot(a, a))); };
    seen.left = of_length_1(turned(corner(x0, y0), against(corner(x0, y1))));
    const vec2 right = of_length_1(turned(against(corner(x1, y0)), corner(x1, y1)));
    const Real angle = angle_of(turned(seen.left, right));
    seen.solid_angle = angle < 0 ? angle + 2 * pi : angle;
    seen.x0 = x0, seen.x1 = x1, seen.y0 = y0, seen.y1 = y1, seen.height = z;
    return seen;
}

/// A point of a quad that is_wide, uniform in solid angle.
[[gnu::always_inline]] inline LightSample sample_by_angle(const SeenQuad& q, vec2 u) {
    const auto between = [](Real a, Real low, Real high) { return a < low ? low : a > high ? high : a; };
    const Real z = q.height;

    // x: what is to the left of it has the share u.x of the solid angle
    const vec2 turn = turned(unit_circle(u.x * q.solid_angle * (1 / (2 * pi))), {q.left.x, -q.left.y});
    const Real lower = 1 / std::sqrt(z * z + q.y0 * q.y0), upper = 1 / std::sqrt(z * z + q.y1 * q.y1);
    const Real along = q.y1 * upper - turn.x * q.y0 * lower, across = turn.y * z * lower;
    const Real over = (along - across) * (along + across);
    const Real cut = z * turn.y / std::sqrt(over > 0 ? over : 0);
    const Real x = between(along < 0 ? -cut : cut, q.x0, q.x1);

    // y, whose sine is uniform between the edges
    const Real from_edge = x * x + z * z;
    const Real low = q.y0 / std::sqrt(from_edge + q.y0 * q.y0), high = q.y1 / std::sqrt(from_edge + q.y1 * q.y1);
    const Real sine = low + u.y * (high - low);
    const Real y = between(sine * std::sqrt(from_edge / (1 - sine * sine)), q.y0, q.y1);

    const Real distance = std::sqrt(from_edge + y * y);
    return {(x * q.x + y * q.y - z * q.normal) * (1 / distance), distance, 1 / q.solid_angle};
}

/// A point of a quad by solid angle, where that is_wide; elsewhere the one that light_sample has found by area.
[[gnu::always_inline]] inline LightSample by_angle_or(const LightSample& by_area, const Quad& quad, vec3 p, vec2 u) {
    const SeenQuad seen = seen_from(quad, p);
    const LightSample by_angle = sample_by_angle(seen, u);
    const bool w = seen.is_wide();
    return {{w ? by_angle.direction.x : by_area.direction.x, w ? by_angle.direction.y : by_area.direction.y,
             w ? by_angle.direction.z : by_area.direction.z},
            w ? by_angle.distance : by_area.distance,
            w ? by_angle.density : by_area.density};
}

}  // namespace rt
