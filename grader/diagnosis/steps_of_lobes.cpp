#include <algorithm>

#include "diagnosis/steps_made.h"

namespace grade {

namespace {

using namespace rt;

/// The direction whose cosine with an axis is c.
vec3 about(vec3 axis, Real c, Real turn) {
    const Real s = safe_sqrt(1 - c * c);
    const vec2 circle = circle_of(turn);
    return frame_about(axis).to_world({s * circle.x, s * circle.y, c});
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

    Real cos_alpha() const { return std::pow(u.x, 1 / (n + 1)); }
    vec3 direction() const { return about(axis, cos_alpha(), u.y); }
    Real theta() const { return dot(direction(), outward); }
    Real power() const { return std::pow(cos_alpha(), n); }
    /// With a weight of its own over cos(theta), and all directions on the side that counts.
    Row mirrored(Real weight) const {
        if (axis == vec3(0)) return scattered(0);
        const Real below = std::min(theta(), 0.0);
        return row(Scattered{direction() - 2 * below * outward, Color(weight * std::abs(theta()))});
    }
    Row scattered(Real weight) const {
        return axis == vec3(0) ? row(Scattered{d, Color(0)}) : row(Scattered{direction(), Color(weight)});
    }
};

Lobe lobe_of(vec3 d, vec3 n, Real exponent, vec2 u) { return {d - 2 * dot(d, n) * n, d, n, exponent, u}; }
Lobe lobe_of(vec3 d, vec3 n, Real from, Real to, Real exponent, vec2 u) {
    return {refracted(d, n, from, to), d, -n, exponent, u};
}

template <class... Arguments>
std::vector<Steps> of_lobe(const char* formula) {
    return {
        steps<Arguments...>(
            formula,
            "Real cos(theta); Real cos(alpha); Real n + 2; Real n + 1; Real the factor cos(theta); Real the exponent n "
            "of the lobe; vec3 the axis; bool a ray on the wrong side mirrored at the surface and counted; bool a ray "
            "on the wrong side of the surface, below it, counted with abs(cos(theta)); bool directions uniform on the "
            "hemisphere about the axis, with u.x as the cosine; bool directions uniform on the hemisphere about the "
            "axis, with 1 - u.x as the cosine",
            +[](const Arguments&... arguments) {
                const Lobe l = lobe_of(arguments...);
                return row(l.theta(), l.cos_alpha(), l.n + 2, l.n + 1, l.theta(), l.n, l.axis, false, false, false,
                           false);
            },
            +[](const double* s, const Arguments&... arguments) {
                Lobe l = lobe_of(arguments...);
                const Real weight = s[2] / s[3], theta = l.theta();
                if (s[9] != 0) return l.mirrored(weight);
                if (s[10] != 0) return l.scattered(weight * std::abs(theta));
                if (s[0] != theta || s[1] != l.cos_alpha()) return l.scattered(s[0] > 0 ? weight * s[0] : 0);
                l.axis = vec3(s[6], s[7], s[8]), l.n = s[5];
                // a lobe with n = 0 is uniform
                if (s[11] != 0 || s[12] != 0) l.n = 0, l.u.x = s[11] != 0 ? l.u.x : 1 - l.u.x;
                return l.scattered(l.theta() > 0 ? weight * (s[4] != theta ? s[4] : l.theta()) : 0);
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
            })};
}

std::vector<Steps> of_glossy() {
    return of_lobe<vec3, vec3, Real, vec2>(
        "weight = (n + 2) / (n + 1) * cos(theta) for cos(theta) > 0, the axis = d - 2 * dot(d, n) * n");
}

std::vector<Steps> of_translucency() {
    return of_lobe<vec3, vec3, Real, Real, Real, vec2>(
        "weight = (n + 2) / (n + 1) * cos(theta) for cos(theta) > 0, the axis = refracted_direction(d, n, ior_from, "
        "ior_to)");
}

/// A step for what is made of the random numbers and turned into the world, one for what comes out.
std::vector<Steps> of_bleeding() {
    return {steps(
        "direction = frame_about(n).to_world(local), local = cosine_hemisphere(u).direction",
        "vec3 local; vec3 direction; bool local.z * n + local.x * y + local.y * z: the axes of the frame in another "
        "order; bool directions uniform on the hemisphere, with u.x as the cosine; bool directions uniform on the "
        "hemisphere, with 1 - u.x as the cosine",
        +[](const vec3& n, const Color&, const vec2& u) {
            const Real c = safe_sqrt(1 - u.x);
            return row(about({0, 0, 1}, c, u.y), about(n, c, u.y), false, false, false);
        },
        +[](const double* s, const vec3& n, const Color& albedo, const vec2& u) {
            const vec3 usual = about({0, 0, 1}, safe_sqrt(1 - u.x), u.y), local(s[0], s[1], s[2]);
            const vec3 direction = s[6] != 0                ? frame_about(n).to_world({local.z, local.x, local.y})
                                   : s[7] != 0 || s[8] != 0 ? about(n, s[7] != 0 ? u.x : 1 - u.x, u.y)
                                   : local != usual         ? frame_about(n).to_world(local)
                                                            : vec3(s[3], s[4], s[5]);
            return row(Scattered{direction, albedo});
        })};
}

}  // namespace

std::vector<Steps> steps_of_lobes(const std::string& fragment) {
    if (fragment == "glossy_reflection") return of_glossy();
    if (fragment == "translucency") return of_translucency();
    if (fragment == "color_bleeding") return of_bleeding();
    return {};
}

}  // namespace grade
