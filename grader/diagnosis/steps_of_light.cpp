#include <algorithm>

#include "diagnosis/steps_made.h"

namespace grade {

namespace {

using namespace rt;

std::vector<Steps> of_point_light() {
    return {steps(
                "intensity * max(dot(n, d), 0) / distance^2", "Real dot(n, d); Real distance^2",
                +[](const PointLight& light, const vec3& p, const vec3& n) {
                    const vec3 to = light.directional ? light.position : light.position - p;
                    return row(dot(n, unit(to)), light.directional ? 1 : dot(to, to));
                },
                +[](const double* s, const PointLight& light, const vec3&, const vec3&) {
                    return row(light.intensity * (s[0] > 0 ? s[0] : 0) / s[1]);
                }),
            steps(
                "intensity * max(dot(n, d), 0) / distance^2, d = unit(light.position - p)",
                "vec3 d; vec3 light.position - p",
                +[](const PointLight& light, const vec3& p, const vec3&) {
                    const vec3 to = light.directional ? light.position : light.position - p;
                    return row(unit(to), to);
                },
                +[](const double* s, const PointLight& light, const vec3&, const vec3& n) {
                    const vec3 to(s[3], s[4], s[5]);
                    return row(light.intensity * std::max(dot(n, vec3(s[0], s[1], s[2])), 0.0) /
                               (light.directional ? 1 : dot(to, to)));
                })};
}

Real cosine_of_highlight(vec3 n, vec3 to_light, vec3 to_viewer) {
    return dot(2 * dot(n, to_light) * n - to_light, to_viewer);
}

/// What phong and direct_light reflect of light that comes straight.
struct Surface {
    const Material& material;
    Real cosine, along_r;  // n . d, r . c

    Color reflected(Real power) const { return cosine / pi * material.albedo + power * material.specular; }
    Color reflected() const { return reflected(power_of(along_r)); }
    Real power_of(Real x) const { return x > 0 ? std::pow(x, material.shininess) : 0; }
};

Row steps_of_surface(vec3 n, vec3 to_light, vec3 to_viewer) {
    Row taken = row(dot(n, to_light), dot(n, to_light), cosine_of_highlight(n, to_light, to_viewer));
    taken.resize(18);
    taken[16] = dot(n, unit(to_light + to_viewer));
    return taken;
}

/// Of the steps of a surface, the light that it reflects of `light`: n . d before the albedo, n . d in the test, r . c.
Color reflected_by_steps(const double* s, const Material& material, Color light) {
    if (!(s[1] > 0) && s[4] == 0) return Color(0);
    const Surface surface{material, s[1] > 0 ? s[0] : 0, s[2]};
    const Real a = material.shininess, power = s[3] != 0    ? std::max(s[2], 0.0) * a
                                               : s[15] != 0 ? std::pow(s[2], a)
                                               : s[17] != 0 ? std::pow(a, std::max(s[2], 0.0))
                                                            : surface.power_of(s[2]);
    const Real before = s[5] != 0   ? (a + 2) / (2 * pi)
                        : s[6] != 0 ? (a + 1) / (2 * pi)
                        : s[7] != 0 ? (a + 8) / (8 * pi)
                        : s[8] != 0 ? 1 / pi
                        : s[9] != 0 ? s[0]
                                    : 1;
    const Color one = light == Color(0) ? light : Color(1);
    const Color diffuse = surface.cosine / pi * material.albedo * (s[14] != 0 ? material.specular : Color(1)),
                highlight = before * power * material.specular * (s[13] != 0 ? material.albedo : Color(1));
    return (s[11] != 0 ? one : light) * diffuse + (s[10] != 0 ? one : light) * highlight;
}

constexpr const char* surface_names =
    "Real dot(n, d); Real dot(n, d) in the test; Real dot(r, c); bool a product in place of the power: max(dot(r, c), "
    "0) * shininess; bool the highlight where dot(n, d) <= 0 as well; bool a factor (shininess + 2) / (2 * pi) before "
    "the highlight; bool a factor (shininess + 1) / (2 * pi) before the highlight; bool a factor (shininess + 8) / (8 "
    "* pi) before the highlight; bool a factor 1 / pi before the highlight; bool a factor dot(n, d) before the "
    "highlight; bool the highlight not multiplied by the light; bool the diffuse part not multiplied by the light; "
    "bool "
    "nothing at all returned where dot(n, d) <= 0, not even ambient light; bool albedo before the highlight as well; "
    "bool specular before the diffuse part as well; bool dot(r, c) not cut off at 0 before the power; Real dot(n, h) "
    "with the half vector h = unit(d + c); bool pow(shininess, max(dot(r, c), 0)), base and exponent exchanged";

constexpr const char* surface_formula = "dot(n, d) / pi * albedo + pow(max(dot(r, c), 0), shininess) * specular";

/// Of phong, or of direct_light: what glows by itself, and what light falls from d.
struct Lit {
    const Material& material;
    Color glow, light;
    vec3 n, d, c;

    Row with(Real cosine, vec3 r) const {
        const Surface surface{material, cosine, dot(r, c)};
        return row(glow + (cosine > 0 ? light * surface.reflected() : Color(0)));
    }
};

Lit lit(const Material& m, Color ambient, Color irradiance, vec3 n, vec3 d, vec3 c) {
    return {m, m.ambient * ambient, irradiance, n, d, c};
}
Lit lit(const Material& m, Color radiance, const LightSample& light, vec3 n, vec3 c) {
    return {m, Color(0), light.density > 0 ? radiance / light.density : Color(0), n, light.direction, c};
}

template <class... Arguments>
std::vector<Steps> of_surface() {
    return {steps<Arguments...>(
                surface_formula, surface_names,
                +[](const Arguments&... arguments) {
                    const Lit all = lit(arguments...);
                    return steps_of_surface(all.n, all.d, all.c);
                },
                +[](const double* s, const Arguments&... arguments) {
                    const Lit all = lit(arguments...);
                    if (s[12] != 0 && !(s[1] > 0)) return row(Color(0));
                    return row(all.glow + reflected_by_steps(s, all.material, all.light));
                }),
            steps<Arguments...>(
                "r = 2 * dot(n, d) * n - d", "vec3 r; Real cosine; Real 2 * dot(n, d)",
                +[](const Arguments&... arguments) {
                    const Lit all = lit(arguments...);
                    const Real cosine = dot(all.n, all.d);
                    return row(2 * cosine * all.n - all.d, cosine, 2 * cosine);
                },
                +[](const double* s, const Arguments&... arguments) {
                    const Lit all = lit(arguments...);
                    const Real twice = 2 * dot(all.n, all.d);
                    return all.with(s[3], s[4] != twice ? s[4] * all.n - all.d : vec3(s[0], s[1], s[2]));
                }),
            steps<Arguments...>(
                "", "Real dot(n, d)",
                +[](const Arguments&... arguments) { return row(dot(lit(arguments...).n, lit(arguments...).d)); },
                +[](const double* s, const Arguments&... arguments) {
                    const Lit all = lit(arguments...);
                    return all.with(s[0], 2 * s[0] * all.n - all.d);
                })};
}

/// The light of a sample, before the diffuse part and before the highlight.
std::vector<Steps> of_light_sample() {
    std::vector<Steps> all = of_surface<Material, Color, LightSample, vec3, vec3>();
    all.push_back(steps(
        "dot(n, d) / pi * albedo * L / density + pow(max(dot(r, c), 0), shininess) * specular * L / density",
        "Color L of the diffuse part; Color L of the highlight; Real density of the diffuse part; Real density of the "
        "highlight",
        +[](const Material&, const Color& radiance, const LightSample& light, const vec3&, const vec3&) {
            return row(radiance, radiance, light.density, light.density);
        },
        +[](const double* s, const Material& m, const Color&, const LightSample& light, const vec3& n, const vec3& c) {
            const Real cosine = dot(n, light.direction), along = cosine_of_highlight(n, light.direction, c);
            if (!(cosine > 0) || !(light.density > 0)) return row(Color(0));
            const Color diffuse = cosine / pi * m.albedo * Color(s[0], s[1], s[2]) / s[6];
            const Color highlight = (along > 0 ? std::pow(along, m.shininess) : 0) * m.specular;
            return row(diffuse + highlight * Color(s[3], s[4], s[5]) / s[7]);
        }));
    return all;
}

Real fresnel_of(Real s, Real p) { return (s * s + p * p) / 2; }

/// To the amplitudes s and p.
std::vector<Steps> of_amplitudes() {
    return {
        steps(
            "c2 = sqrt(1 - e^2 * (1 - c1^2)), e = e1 / e2",
            "Real e^2; Real 1 - c1^2; Real c1^2; bool 0 at total internal reflection; bool no root: c2 = 1 - e^2 * (1 "
            "- c1^2); Real (1 - c1)^2",
            +[](const Real& c1, const Real& e1, const Real& e2) {
                return row(sqr(e1 / e2), 1 - c1 * c1, c1 * c1, false, false, sqr(1 - c1));
            },
            +[](const double* s, const Real& c1, const Real& e1, const Real& e2) {
                const Real squared = 1 - s[0] * (s[2] != c1 * c1 ? 1 - s[2] : s[1]);
                if (squared < 0) return row(s[3] != 0 ? 0.0 : 1.0);
                if (e1 == e2) return row(0.0);
                const Real c2 = s[4] != 0 ? squared : std::sqrt(squared);
                return row(
                    fresnel_of((e1 * c1 - e2 * c2) / (e1 * c1 + e2 * c2), (e2 * c1 - e1 * c2) / (e2 * c1 + e1 * c2)));
            }),
        steps(
            "s = (e1 * c1 - e2 * c2) / (e1 * c1 + e2 * c2), p = (e2 * c1 - e1 * c2) / (e2 * c1 + e1 * c2)",
            "Real c2 in s; Real c2 in p; Real e1 * c1 - e2 * c2; Real e2 * c1 - e1 * c2; Real e1 * c1 + e2 * c2; Real "
            "e2 * c1 + e1 * c2",
            +[](const Real& c1, const Real& e1, const Real& e2) {
                const Real c2 = std::sqrt(1 - sqr(e1 / e2) * (1 - c1 * c1));
                return row(c2, c2, e1 * c1 - e2 * c2, e2 * c1 - e1 * c2, e1 * c1 + e2 * c2, e2 * c1 + e1 * c2);
            },
            +[](const double* s, const Real& c1, const Real& e1, const Real& e2) {
                if (!(s[0] == s[0])) return row(1.0);
                if (e1 == e2) return row(0.0);
                const Real c2 = std::sqrt(1 - sqr(e1 / e2) * (1 - c1 * c1));
                const auto one = [&](Real c, Real top, Real bottom, Real own, Real other) {
                    return c != c2 ? (own - other * c) / (own + other * c) : top / bottom;
                };
                return row(fresnel_of(one(s[0], s[2], s[4], e1 * c1, e2), one(s[1], s[3], s[5], e2 * c1, e1)));
            })};
}

/// From s and p to the reflected share.
std::vector<Steps> of_reflected_share() {
    return {
        steps(
            "F = (s * s + p * p) / 2 of c1 and c2", "Real c2",
            +[](const Real& c1, const Real& e1, const Real& e2) {
                return row(std::sqrt(1 - sqr(e1 / e2) * (1 - c1 * c1)));
            },
            +[](const double* s, const Real& c1, const Real& e1, const Real& e2) {
                if (!(s[0] == s[0])) return row(1.0);
                return row(e1 == e2 ? 0.0
                                    : fresnel_of((e1 * c1 - e2 * s[0]) / (e1 * c1 + e2 * s[0]),
                                                 (e2 * c1 - e1 * s[0]) / (e2 * c1 + e1 * s[0])));
            }),
        steps(
            "F = (s * s + p * p) / 2",
            "Real s; Real p; bool s * p in place of the squares; bool no squares: (s + p) / 2; bool no squares: "
            "(abs(s) + abs(p)) / 2; bool the square of the mean: ((s + p) / 2)^2; bool no half: s * s + p * p; bool s "
            "* s - p * p in place of the sum",
            +[](const Real& c1, const Real& e1, const Real& e2) {
                const Real c2 = std::sqrt(1 - sqr(e1 / e2) * (1 - c1 * c1));
                Row taken = row((e1 * c1 - e2 * c2) / (e1 * c1 + e2 * c2), (e2 * c1 - e1 * c2) / (e2 * c1 + e1 * c2));
                taken.resize(8);
                return taken;
            },
            +[](const double* s, const Real&, const Real& e1, const Real& e2) {
                if (!(s[0] == s[0])) return row(1.0);
                if (e1 == e2) return row(0.0);
                if (s[2] != 0) return row(s[0] * s[1]);
                if (s[3] != 0) return row((s[0] + s[1]) / 2);
                if (s[4] != 0) return row((std::abs(s[0]) + std::abs(s[1])) / 2);
                if (s[5] != 0) return row(sqr((s[0] + s[1]) / 2));
                if (s[7] != 0) return row((s[0] * s[0] - s[1] * s[1]) / 2);
                return row(fresnel_of(s[0], s[1]) * (s[6] != 0 ? 2 : 1));
            }),
        steps(
            "", "Real F; Real Schlick's approximation",
            +[](const Real& c1, const Real& e1, const Real& e2) {
                const Real c2 = std::sqrt(1 - sqr(e1 / e2) * (1 - c1 * c1)), straight = sqr((e1 - e2) / (e1 + e2));
                if (!(c2 == c2)) return row(1.0, 1.0);
                const Real s = (e1 * c1 - e2 * c2) / (e1 * c1 + e2 * c2), p = (e2 * c1 - e1 * c2) / (e2 * c1 + e1 * c2);
                return row(e1 == e2 ? 0.0 : fresnel_of(s, p), straight + (1 - straight) * std::pow(1 - c1, 5));
            },
            +[](const double* s, const Real&, const Real&, const Real&) { return row(s[0]); })};
}

std::vector<Steps> of_fresnel() {
    std::vector<Steps> all = of_amplitudes();
    for (Steps& more : of_reflected_share()) all.push_back(std::move(more));
    return all;
}

std::vector<Steps> of_whitted() {
    return {steps(
        "",
        "bool glass only where all channels of the transmittance are positive; bool glass only where the first channel "
        "of the transmittance is positive; bool glass everywhere; bool glass nowhere; Real fresnel before the "
        "reflectance; Real (1 - fresnel) before the transmittance; Color the reflectance of glass; Color the "
        "transmittance of glass; Color the local weight of what is opaque; Color the local weight of glass; Color 1 - "
        "reflectance; Color 1 - transmittance; Color 1 - reflectance - transmittance; Color the weight that mirror and "
        "glass leave",
        +[](const Material& m, const Real& f) {
            const vec3 t = m.transmittance, r = m.reflectance;
            const bool glass = t.x > 0 || t.y > 0 || t.z > 0;
            const Color left = Color(1) - (glass ? f * r + (1 - f) * t : r);
            return row(false, false, false, false, f, 1 - f, r, t, Color(1), Color(1), Color(1) - r, Color(1) - t,
                       Color(1) - r - t, left);
        },
        +[](const double* s, const Material& m, const Real&) {
            const vec3 t = m.transmittance;
            const bool any = t.x > 0 || t.y > 0 || t.z > 0, all = t.x > 0 && t.y > 0 && t.z > 0;
            const bool glass = s[2] != 0 || (s[3] == 0 && (s[0] != 0 ? all : s[1] != 0 ? t.x > 0 : any));
            if (!glass) return row(Outgoing{Color(s[12], s[13], s[14]), m.reflectance, Color(0)});
            return row(
                Outgoing{Color(s[15], s[16], s[17]), s[4] * Color(s[6], s[7], s[8]), s[5] * Color(s[9], s[10], s[11])});
        })};
}

}  // namespace

std::vector<Steps> steps_of_light(const std::string& fragment) {
    if (fragment == "point_irradiance") return of_point_light();
    if (fragment == "phong") return of_surface<Material, Color, Color, vec3, vec3, vec3>();
    if (fragment == "direct_light") return of_light_sample();
    if (fragment == "fresnel_dielectric") return of_fresnel();
    if (fragment == "whitted") return of_whitted();
    return {};
}

}  // namespace grade
