#include <algorithm>

#include "diagnosis/steps_made.h"

namespace grade {

namespace {

using namespace rt;

vec2 circle_of(Real turn) { return {std::cos(2 * pi * turn), std::sin(2 * pi * turn)}; }
vec2 on_disk(vec2 u) { return std::sqrt(u.x) * circle_of(u.y); }

std::vector<Steps> of_film() {
    return {steps(
        "low + cell * size, size = high - low", "vec2 cell; vec2 low; vec2 size",
        +[](const Extent& pixel, const int& i, const int& n, const vec2& u) {
            const Real columns = std::floor(std::sqrt(Real(n))), column = std::floor(i * columns / n);
            const Real first = std::ceil(column * n / columns), next = std::ceil((column + 1) * n / columns);
            return row(vec2((first + u.x * (next - first)) / n, (i - first + u.y) / (next - first)), pixel.low,
                       pixel.high - pixel.low);
        },
        +[](const double* s, const Extent&, const int&, const int&, const vec2&) {
            return row(FilmSample{vec2(s[2], s[3]) + vec2(s[0], s[1]) * vec2(s[4], s[5]), 1});
        })};
}

std::vector<Steps> of_mean() {
    using Colors = std::vector<Color>;
    using Weights = std::vector<Real>;
    return {steps(
        "the sum of weight[i] * radiance[i] over radiance.size()",
        "int the number of terms; int radiance.size(); bool weights left out; bool weights squared; bool 1 / weight[i] "
        "in place of weight[i]; bool the sum of the weights in place of the number of samples; bool a sum that starts "
        "at radiance[0], which is added again; bool the last sample alone; bool weight[0] for all; bool the first "
        "sample left out; bool the last sample left out; bool the first channel in all; bool the mean of the channels "
        "in all; bool the mean of the radiance times the mean of the weights",
        +[](const Colors& all, const Weights&) {
            Row taken = row(int(all.size()), int(all.size()));
            taken.resize(14);
            return taken;
        },
        +[](const double* s, const Colors& all, const Weights& weights) {
            Color sum = s[6] != 0 ? all.at(0) : Color(0), plain(0);
            Real of_weights = 0;
            const std::size_t last = std::min(all.size() - (s[10] != 0), std::size_t(std::max(s[0], 0.0)));
            for (std::size_t i = s[7] != 0 ? all.size() - 1 : s[9] != 0; i < last; ++i) {
                const Real w = weights.at(s[8] != 0 ? 0 : i);
                sum += (s[2] != 0 ? 1 : s[3] != 0 ? w * w : s[4] != 0 ? 1 / w : w) * all[i];
                of_weights += w, plain += all[i];
            }
            if (s[13] != 0) return row(plain * of_weights / sqr(Real(all.size())));
            if (s[11] != 0) sum = Color(sum.x);
            if (s[12] != 0) sum = Color((sum.x + sum.y + sum.z) / 3);
            return row(sum / (s[5] != 0 ? of_weights : s[1]));
        })};
}

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

Row flat_light(const Emitter& light, vec3 p, vec2 u) {
    const vec3 to = point_of(light, on_light(light, u)) - p;
    const Real cosine = cosine_at(light, to);
    return row(LightSample{unit(to), length(to), cosine > 0 ? dot(to, to) / (cosine * area(light)) : 0});
}

std::vector<Steps> of_light() {
    return {
        steps(
            "density = distance^2 / (cos * area) for cos > 0, the front side, with cos = -dot(unit(point - p), "
            "unit(normal(light)))",
            "Real distance^2; Real cos; Real area; Real cos in the density; bool cos <= 0, the back side, counted; "
            "Real distance^2 / cos; Real -dot(unit(point - p), normal(light)); Real -dot(point - p, "
            "unit(normal(light))); Real distance",
            +[](const Emitter& light, const vec3& p, const vec2& u) {
                const vec3 to = point_of(light, on_light(light, u)) - p;
                const Real cosine = cosine_at(light, to), distance = length(to);
                return row(dot(to, to), cosine, area(light), cosine, false, dot(to, to) / cosine,
                           cosine * length(normal(light)), cosine * distance, distance);
            },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                if (light.kind == Emitter::Kind::sphere) return sphere_light(light, p, u);
                const vec3 to = point_of(light, on_light(light, u)) - p;
                const Real right = cosine_at(light, to), cosine = s[1] != right ? s[1] : s[3];
                const Real whole = s[5] != dot(to, to) / right ? s[5] : s[0] / cosine;
                return row(LightSample{unit(to), length(to), s[1] > 0 || s[4] != 0 ? whole / s[2] : 0});
            }),
        steps(
            "point = center + at.x * u + at.y * v with at = 2 * u - 1 of a quad, center + radius * (at.x * x + at.y * "
            "y) with at = uniform_disk(u).point of a disc",
            "vec2 at; Real radius; bool the disc along the axes of the world, not turned to its normal; bool u in "
            "place of 2 * u - 1, which covers a quarter of the quad from its centre; bool u - 0.5 in place of 2 * u - "
            "1: "
            "u and v are half edges, so a quarter of the quad is covered",
            +[](const Emitter& light, const vec3&, const vec2& u) {
                return row(on_light(light, u), light.kind == Emitter::Kind::disc ? light.disc.radius : 1, false, false,
                           false);
            },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                if (light.kind == Emitter::Kind::sphere) return sphere_light(light, p, u);
                const bool is_disc = light.kind == Emitter::Kind::disc;
                const vec2 on_quad = s[4] != 0 ? u : s[5] != 0 ? u - vec2(0.5) : vec2(s[0], s[1]);
                const vec2 at = is_disc ? s[2] / light.disc.radius * vec2(s[0], s[1]) : on_quad;
                const vec3 to =
                    (is_disc && s[3] != 0 ? light.disc.center + light.disc.radius * vec3(at, 0) : point_of(light, at)) -
                    p;
                const Real cosine = cosine_at(light, to);
                return row(LightSample{unit(to), length(to), cosine > 0 ? dot(to, to) / (cosine * area(light)) : 0});
            }),
        steps(
            "of a sphere, sine = radius / distance of its centre", "Real sine; Real radius / distance^2; Real distance",
            +[](const Emitter& light, const vec3& p, const vec2&) {
                const Real far = length(light.sphere.center - p);
                return row(light.sphere.radius / far, light.sphere.radius / (far * far), far);
            },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                return light.kind == Emitter::Kind::sphere ? sphere_light(light, p, u, s[0]) : flat_light(light, p, u);
            }),
        steps(
            "of a sphere, the axis of the cone is unit(center - p)", "vec3 the axis; vec3 center - p",
            +[](const Emitter& light, const vec3& p, const vec2&) {
                return row(unit(light.sphere.center - p), light.sphere.center - p);
            },
            +[](const double* s, const Emitter& light, const vec3& p, const vec2& u) {
                const vec3 axis(s[0], s[1], s[2]);
                return light.kind == Emitter::Kind::sphere ? sphere_light(light, p, u, sine_of(light, p), axis)
                                                           : flat_light(light, p, u);
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
                if (light.kind != Emitter::Kind::sphere) return flat_light(light, p, u);
                all.distance = s[1] - s[0];
                return row(all);
            })};
}

/// A lobe's direction about an axis, and its angle to it.
std::pair<vec3, Real> lobe_about(vec3 axis, Real exponent, vec2 u) {
    const Real c = std::pow(u.x, 1 / (exponent + 1)), s = safe_sqrt(1 - c * c);
    const vec2 circle = circle_of(u.y);
    return {frame_about(axis).to_world({s * circle.x, s * circle.y, c}), c};
}

vec3 refracted(vec3 d, vec3 n, Real from, Real to) {
    const Real along = -from * dot(d, n), squared = (to - from) * (to + from) + along * along;
    return squared < 0 ? vec3(0) : (from * d + (along - std::sqrt(squared)) * n) / to;
}

/// Of glossy_reflection, or of translucency: its axis, and the side on which its directions count.
struct Lobe {
    vec3 axis, d, outward;
    Real n;
    vec2 u;

    vec3 direction() const { return lobe_about(axis, n, u).first; }
    Real theta() const { return dot(direction(), outward); }
    Real power() const { return std::pow(lobe_about(axis, n, u).second, n); }
    Row scattered(Real weight) const {
        return axis == vec3(0) ? row(Scattered{d, Color(0)}) : row(Scattered{direction(), Color(weight)});
    }
};

Lobe lobe_of(vec3 d, vec3 n, Real exponent, vec2 u) { return {d - 2 * dot(d, n) * n, d, n, exponent, u}; }
Lobe lobe_of(vec3 d, vec3 n, Real from, Real to, Real exponent, vec2 u) {
    return {refracted(d, n, from, to), d, -n, exponent, u};
}

template <class... Arguments>
std::vector<Steps> of_lobe(const char* formula_of_axis) {
    return {steps<Arguments...>(
                "weight = (n + 2) / (n + 1) * cos(theta) for cos(theta) > 0",
                "Real cos(theta); Real cos(alpha); Real n + 2; Real n + 1; Real the factor cos(theta)",
                +[](const Arguments&... arguments) {
                    const Lobe l = lobe_of(arguments...);
                    return row(l.theta(), lobe_about(l.axis, l.n, l.u).second, l.n + 2, l.n + 1, l.theta());
                },
                +[](const double* s, const Arguments&... arguments) {
                    const Lobe l = lobe_of(arguments...);
                    return l.scattered(s[0] > 0 ? s[2] / s[3] * (s[0] != l.theta() ? s[0] : s[4]) : 0);
                }),
            steps<Arguments...>(
                "weight = brdf * cos(theta) / density for cos(theta) > 0, brdf = (n + 2) / (2 * pi) * cos(alpha)^n, "
                "density = (n + 1) / (2 * pi) * cos(alpha)^n",
                "Real brdf; Real density; Real cos(theta); Real cos(alpha)^n",
                +[](const Arguments&... arguments) {
                    const Lobe l = lobe_of(arguments...);
                    const Real power = l.power() / (2 * pi);
                    return row((l.n + 2) * power, (l.n + 1) * power, l.theta(), l.power());
                },
                +[](const double* s, const Arguments&... arguments) {
                    const Lobe l = lobe_of(arguments...);
                    return l.scattered(l.theta() > 0 ? s[0] * s[2] / s[1] : 0);
                }),
            steps<Arguments...>(
                formula_of_axis, "vec3 the axis",
                +[](const Arguments&... arguments) { return row(lobe_of(arguments...).axis); },
                +[](const double* s, const Arguments&... arguments) {
                    Lobe l = lobe_of(arguments...);
                    l.axis = vec3(s[0], s[1], s[2]);
                    return l.scattered(l.theta() > 0 ? (l.n + 2) / (l.n + 1) * l.theta() : 0);
                })};
}

std::vector<Steps> of_glossy() {
    return of_lobe<vec3, vec3, Real, vec2>("the axis of the lobe is d - 2 * dot(d, n) * n");
}

std::vector<Steps> of_translucency() {
    return of_lobe<vec3, vec3, Real, Real, Real, vec2>(
        "the axis of the lobe is refracted_direction(d, n, ior_from, ior_to)");
}

/// A step for what is made of the random numbers and turned into the world, one for what comes out.
std::vector<Steps> of_bleeding() {
    return {steps(
        "direction = frame_about(n).to_world(local), local = cosine_hemisphere(u).direction",
        "vec3 local; vec3 direction; bool local.z * n + local.x * y + local.y * z: the axes of the frame in another "
        "order",
        +[](const vec3& n, const Color&, const vec2& u) {
            const vec2 p = on_disk(u);
            const vec3 local(p.x, p.y, safe_sqrt(1 - u.x));
            return row(local, frame_about(n).to_world(local), false);
        },
        +[](const double* s, const vec3& n, const Color& albedo, const vec2& u) {
            const vec2 p = on_disk(u);
            const Frame frame = frame_about(n);
            const vec3 usual(p.x, p.y, safe_sqrt(1 - u.x)), local(s[0], s[1], s[2]);
            if (s[6] != 0) return row(Scattered{frame.to_world({local.z, local.x, local.y}), albedo});
            return row(Scattered{local != usual ? frame.to_world(local) : vec3(s[3], s[4], s[5]), albedo});
        })};
}

std::vector<Steps> of_shutter() {
    return {steps(
        "open + u * (close - open)", "Real open; Real u; Real close - open",
        +[](const Shutter& shutter, const Real& u) { return row(shutter.open, u, shutter.close - shutter.open); },
        +[](const double* s, const Shutter&, const Real&) { return row(s[0] + s[1] * s[2]); })};
}

std::vector<Steps> of_flight() {
    return {steps(
        "-log(1 - u) / extinction",
        "Real log(1 - u); bool log(1 + u) / extinction; bool -log(1 + u) / extinction; bool exp(-u / extinction); bool "
        "exp(-u * extinction); bool extinction * exp(-extinction * u); bool a product with extinction in place of the "
        "division",
        +[](const Real&, const Real& u) { return row(std::log1p(-u), false, false, false, false, false, false); },
        +[](const double* s, const Real& given, const Real& u) {
            const Real extinction = s[6] != 0 ? 1 / given : given;
            if (s[1] != 0 || s[2] != 0) return row((s[1] != 0 ? 1 : -1) * std::log1p(u) / extinction);
            if (s[3] != 0) return row(std::exp(-u / extinction));
            if (s[5] != 0) return row(extinction * std::exp(-extinction * u));
            return row(s[4] != 0 ? std::exp(-u * extinction) : -s[0] / extinction);
        })};
}

std::vector<Steps> of_lens() {
    return {steps(
                "offset = R * (at.x * right + at.y * up), at = uniform_disk(u).point", "vec2 at",
                +[](const Camera&, const Ray&, const vec2& u) { return row(on_disk(u)); },
                +[](const double* s, const Camera& c, const Ray& ray, const vec2&) {
                    const vec3 offset = c.lens_radius * (s[0] * c.right + s[1] * c.up);
                    const Real t = c.focus / -dot(ray.direction, c.back);
                    return row(Ray{ray.origin + offset, unit(ray.direction - offset / t), 0, inf});
                }),
            steps(
                "unit(d - offset / t), t = focus / cos, cos = -dot(d, back)", "Real t; Real cos; vec3 offset",
                +[](const Camera& c, const Ray& ray, const vec2& u) {
                    const vec2 p = c.lens_radius * on_disk(u);
                    const Real cosine = -dot(ray.direction, c.back);
                    return row(c.focus / cosine, cosine, p.x * c.right + p.y * c.up);
                },
                +[](const double* s, const Camera& c, const Ray& ray, const vec2& u) {
                    const vec2 p = c.lens_radius * on_disk(u);
                    const Real t = s[1] != -dot(ray.direction, c.back) ? c.focus / s[1] : s[0];
                    const vec3 offset(s[2], s[3], s[4]);
                    return row(Ray{ray.origin + p.x * c.right + p.y * c.up, unit(ray.direction - offset / t), 0, inf});
                }),
            steps(
                "unit(point - start), point = eye + t * d, t = focus / cos, start = eye + offset",
                "vec3 point; vec3 start; vec3 offset",
                +[](const Camera& c, const Ray& ray, const vec2& u) {
                    const vec2 p = c.lens_radius * on_disk(u);
                    const Real t = std::min(c.focus / -dot(ray.direction, c.back), 1e12);
                    const vec3 offset = p.x * c.right + p.y * c.up;
                    return row(ray.origin + t * ray.direction, ray.origin + offset, offset);
                },
                +[](const double* s, const Camera& c, const Ray& ray, const vec2& u) {
                    const vec2 p = c.lens_radius * on_disk(u);
                    const vec3 usual = p.x * c.right + p.y * c.up, offset(s[6], s[7], s[8]);
                    const vec3 start = offset != usual ? ray.origin + offset : vec3(s[3], s[4], s[5]);
                    return row(Ray{ray.origin + usual, unit(vec3(s[0], s[1], s[2]) - start), 0, inf});
                })};
}

}  // namespace

std::vector<Steps> steps_of_distribution(const std::string& fragment) {
    if (fragment == "film_sample") return of_film();
    if (fragment == "pixel_mean") return of_mean();
    if (fragment == "light_sample") return of_light();
    if (fragment == "glossy_reflection") return of_glossy();
    if (fragment == "translucency") return of_translucency();
    if (fragment == "free_flight") return of_flight();
    if (fragment == "shutter_time") return of_shutter();
    if (fragment == "color_bleeding") return of_bleeding();
    if (fragment == "lens_ray") return of_lens();
    return {};
}

}  // namespace grade
