#include <algorithm>

#include "diagnosis/steps_made.h"

namespace grade {

namespace {

using namespace rt;

Row sphere_light(const Emitter& light, vec3 p, vec2 u, Real sine, vec3 axis) {
    const vec3 to_center = light.sphere.center - p;
    const Real squared = dot(to_center, to_center), radius2 = sqr(light.sphere.radius);
    const Real sine2 = sine * sine, m = sine2 / (1 + safe_sqrt(1 - sine2)), k = u.x * m;
    const vec2 beside = safe_sqrt(k * (2 - k)) * circle_of(u.y);
    const vec3 direction = frame_about(axis).to_world({beside.x, beside.y, 1 - k});
    const Real along = dot(to_center, direction);
    const vec3 off = to_center - along * direction;
    return row(
        LightSample{direction, along - safe_sqrt(radius2 - dot(off, off)), squared > radius2 ? 1 / (2 * pi * m) : 0});
}

Real sine_of(const Emitter& light, vec3 p) { return light.sphere.radius / length(light.sphere.center - p); }

Row sphere_light(const Emitter& light, vec3 p, vec2 u, Real sine) {
    return sphere_light(light, p, u, sine, unit(light.sphere.center - p));
}

Row sphere_light(const Emitter& light, vec3 p, vec2 u) { return sphere_light(light, p, u, sine_of(light, p)); }

/// In units of the half edges, or of the radius.
vec2 on_light(const Emitter& light, vec2 u) {
    return light.kind == Emitter::Kind::quad ? 2.0 * u - vec2(1) : on_disk(u);
}

vec3 point_of(const Emitter& light, vec2 at) {
    if (light.kind == Emitter::Kind::quad) return light.quad.center + at.x * light.quad.u + at.y * light.quad.v;
    const Frame frame = frame_about(light.disc.normal);
    return light.disc.center + light.disc.radius * (at.x * frame.x + at.y * frame.y);
}

Real cosine_at(const Emitter& light, vec3 to) { return -dot(unit(to), unit(normal(light))); }

/// Of a flat light, with what leads to a point of it.
Row sample_towards(const Emitter& light, vec3 to) {
    const Real cosine = cosine_at(light, to);
    return row(LightSample{unit(to), length(to), cosine > 0 ? dot(to, to) / (cosine * area(light)) : 0});
}

Row right_sample(const Emitter& light, vec3 p, vec2 u) {
    return light.kind == Emitter::Kind::sphere ? sphere_light(light, p, u)
                                               : sample_towards(light, point_of(light, on_light(light, u)) - p);
}

/// Of a quad or a disc.
std::vector<Steps> of_flat_light() {
    return {
        steps(
            "density = distance^2 / (cos * area) for cos > 0, the front side, with cos = -dot(unit(point - p), "
            "unit(normal(light)))",
            "Real area; Real cos; Real distance^2; Real cos in the density; bool cos <= 0, the back side, counted; "
            "Real distance^2 / cos; Real -dot(unit(point - p), normal(light)); Real -dot(point - p, "
            "unit(normal(light))); Real distance",
            +[](const Emitter& light, const vec3& p, const vec2& u) {
                const vec3 to = point_of(light, on_light(light, u)) - p;
                const Real cosine = cosine_at(light, to), distance = length(to);
                return row(area(light), cosine, dot(to, to), cosine, false, dot(to, to) / cosine,
                           cosine * length(normal(light)), cosine * distance, distance);
            },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                if (light.kind == Emitter::Kind::sphere) return sphere_light(light, p, u);
                const vec3 to = point_of(light, on_light(light, u)) - p;
                const Real right = cosine_at(light, to), cosine = s[1] != right ? s[1] : s[3];
                const Real whole = s[5] != dot(to, to) / right ? s[5] : s[2] / cosine;
                return row(LightSample{unit(to), length(to), s[1] > 0 || s[4] != 0 ? whole / s[0] : 0});
            }),
        steps(
            "of a quad, point = center + at.x * u + at.y * v, at = 2 * u - 1",
            "vec2 at; bool u in place of 2 * u - 1, which covers a quarter of the quad from its centre; bool u - 0.5 "
            "in "
            "place of 2 * u - 1: u and v are half edges, so a quarter of the quad is covered",
            +[](const Emitter&, const vec3&, const vec2& u) { return row(2.0 * u - vec2(1), false, false); },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                if (light.kind != Emitter::Kind::quad) return right_sample(light, p, u);
                const vec2 at = s[2] != 0 ? u : s[3] != 0 ? u - vec2(0.5) : vec2(s[0], s[1]);
                return sample_towards(light, point_of(light, at) - p);
            }),
        steps(
            "of a disc, point = center + radius * (at.x * x + at.y * y), at = uniform_disk(u).point",
            "vec2 at; Real radius; bool the disc along the axes of the world, not turned to its normal",
            +[](const Emitter& light, const vec3&, const vec2& u) { return row(on_disk(u), light.disc.radius, false); },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                if (light.kind != Emitter::Kind::disc) return right_sample(light, p, u);
                const vec2 at = s[2] / light.disc.radius * vec2(s[0], s[1]);
                const vec3 point =
                    s[3] != 0 ? light.disc.center + light.disc.radius * vec3(at, 0) : point_of(light, at);
                return sample_towards(light, point - p);
            })};
}

std::vector<Steps> of_sphere_light() {
    return {
        steps(
            "of a sphere, sine = radius / distance of its centre",
            "Real sine; Real radius / distance^2; Real distance; bool no density of 0 for a point inside of the "
            "sphere; "
            "bool no density of 0 for a point inside of the sphere: the sine cut off at 1",
            +[](const Emitter& light, const vec3& p, const vec2&) {
                const Real far = length(light.sphere.center - p);
                return row(light.sphere.radius / far, light.sphere.radius / (far * far), far, false, false);
            },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                if (light.kind != Emitter::Kind::sphere) return right_sample(light, p, u);
                const Real sine = s[4] != 0 ? std::min(s[0], 1.0) : s[0];
                auto all = from_row<LightSample>(sphere_light(light, p, u, sine));
                if (s[3] != 0 || s[4] != 0) all.density = (1 + safe_sqrt(1 - sine * sine)) / (2 * pi * sine * sine);
                return row(all);
            }),
        steps(
            "of a sphere, the axis of the cone is unit(center - p)", "vec3 the axis; vec3 center - p",
            +[](const Emitter& light, const vec3& p, const vec2&) {
                return row(unit(light.sphere.center - p), light.sphere.center - p);
            },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                const vec3 axis(s[0], s[1], s[2]);
                return light.kind == Emitter::Kind::sphere ? sphere_light(light, p, u, sine_of(light, p), axis)
                                                           : right_sample(light, p, u);
            }),
        steps(
            "of a sphere, distance = along - half, half = sqrt(radius^2 - beside^2) half of the ray's way through it",
            "Real half; Real along",
            +[](const Emitter& light, const vec3& p, const vec2& u) {
                const auto all = from_row<LightSample>(sphere_light(light, p, u));
                const Real along = dot(light.sphere.center - p, all.direction);
                return row(along - all.distance, along);
            },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                auto all = from_row<LightSample>(sphere_light(light, p, u));
                if (light.kind != Emitter::Kind::sphere) return right_sample(light, p, u);
                all.distance = s[1] - s[0];
                return row(all);
            })};
}

}  // namespace

std::vector<Steps> steps_of_lamps(const std::string& fragment) {
    if (fragment != "light_sample") return {};
    std::vector<Steps> all = of_flat_light();
    for (Steps& one : of_sphere_light()) all.push_back(std::move(one));
    return all;
}

}  // namespace grade
