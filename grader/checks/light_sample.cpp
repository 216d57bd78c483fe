#include "checks/kit/own_density.h"
#include "checks/kit/shadow_scene.h"
#include "checks/light_sample/checks.h"

namespace grade {

namespace {

using light_sample::emitter, light_sample::flat_light, light_sample::off_light;
using rt::Emitter, rt::LightSample, rt::vec2, rt::vec3;

/// Points behind a flat light get nothing.
Check dark_side() {
    const auto inputs = rows_of(64, [](Generator& random) {
        const Emitter light = emitter(random, chance(random, 0.5) ? Emitter::Kind::quad : Emitter::Kind::disc);
        const vec3 p = rt::center(light) -
                       between(random, 1, 3) * tilted(random, rt::unit(rt::normal(light)), between(random, 0, 1));
        return row(light, p, square(random));
    });
    return probe_check(
        "dark_side", inputs,
        {property({.id = "L4",
                   .what = "density behind the light",
                   .violation = of_call<rt::light_sample>([](const LightSample& s) { return std::abs(s.density); }),
                   .says = "the light shines backwards: behind a quad or a disc the density is 0"})});
}

/// Whether a light shines on a point: on those in front of a flat one, and outside of a sphere.
bool shines(const Emitter& light, vec3 p) {
    if (light.kind == Emitter::Kind::sphere) return glm::length(p - light.sphere.center) >= light.sphere.radius;
    return rt::dot(p - rt::center(light), rt::normal(light)) > 0;
}

/// A lamp of any size from a millimetre to hundreds of metres, and its scale.
std::pair<Emitter, double> of_any_size(Generator& random, Emitter::Kind kind) {
    Emitter light = emitter(random, kind);
    const double scale = chance(random, 0.4) ? 1 : range_between(random, 5e-3, 1e3);
    light.quad = {light.quad.center, scale * light.quad.u, scale * light.quad.v};
    light.disc.radius *= scale, light.sphere.radius *= scale;
    return {light, scale};
}

/// A point in the plane of a lamp that faces along an axis of the world, where nothing rounds.
Row beside_lamp(Generator& draw) {
    Emitter light = emitter(draw, chance(draw, 0.5) ? Emitter::Kind::quad : Emitter::Kind::disc);
    const rt::Frame frame = rt::frame_about(exact_direction(draw));
    light.quad.u = 0.5 * frame.x, light.quad.v = 0.25 * frame.y, light.disc.normal = frame.z;
    return row(light, rt::center(light) + between(draw, 0.1, 3) * frame.x + between(draw, 0.1, 3) * frame.y,
               square(draw));
}

/// A point that is the middle of a flat lamp, where maps of the square have theirs: the sample may be the point itself.
Row on_lamp(Generator& draw) {
    Emitter light = emitter(draw, chance(draw, 0.5) ? Emitter::Kind::quad : Emitter::Kind::disc);
    const rt::Frame frame = rt::frame_about(exact_direction(draw));
    light.quad = {exact_direction(draw), 0.5 * frame.x, 0.25 * frame.y};
    light.disc = {light.quad.center, frame.z, 0.5};
    const double y = chance(draw, 0.5) ? 0.5 : 0;
    return row(light, rt::center(light), vec2(chance(draw, 0.5) ? 0.5 : chance(draw, 0.5) ? 0 : 1 - 0x1p-53, y));
}

/// Lamps of any size, from close by to a thousand sizes away, seen along an axis of the world or anyhow; flat ones from
/// behind and from the side as well, spheres from the inside, and so close that they fill half of the sky.
Check anywhere() {
    const auto flat = [](Generator& draw) {
        const auto [light, scale] = of_any_size(draw, chance(draw, 0.5) ? Emitter::Kind::quad : Emitter::Kind::disc);
        const double side = chance(draw, 0.3) ? -1 : 1, away = scale * range_between(draw, 1, 300);
        const double angle = chance(draw, 0.2) ? std::acos(log_between(draw, 5e-3, 0.1)) : angle_from_axis(draw, 1);
        const vec3 p = rt::center(light) + side * away * tilted(draw, rt::unit(rt::normal(light)), angle);
        return row(light, p, square_with_ends(draw));
    };
    const auto sphere = [](Generator& draw) {
        const Emitter light = of_any_size(draw, Emitter::Kind::sphere).first;
        const vec3 away = chance(draw, 0.5) ? exact_direction(draw) : direction(draw);
        return row(light, light.sphere.center + light.sphere.radius * (1 + range_between(draw, 1e-2, 1000)) * away,
                   square_with_ends(draw));
    };
    const auto within = [](Generator& draw) {
        const Emitter light = emitter(draw, Emitter::Kind::sphere);
        return row(light, light.sphere.center + light.sphere.radius * between(draw, 0, 0.95) * direction(draw),
                   square(draw));
    };
    const Statistic dark =
        property({.id = "L4",
                  .what = "density behind a flat light, or within a sphere",
                  .violation = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2) {
                      return shines(light, p) ? 0.0 : std::abs(s.density);
                  }),
                  .says = "a light sends nothing to a point behind it, or within a sphere: the density is 0"});
    const Statistic on = property(
        {.id = "L1",
         .what = "distance of the samples from the light, in its size",
         .violation = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2 u) {
             return shines(light, p) ? off_light(s, light, p, u) : 0.0;
         }),
         .tolerance = 1e-2,
         .says = "samples lie off the light where it is near or far, or straight along an axis of the world"});
    const Statistic missing = property(
        {.id = "L1",
         .what = "samples in front of a flat light that do not count",
         .violation = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2) {
             // of a sphere, samples may lie on its far side
             const bool may_be_dark = light.kind == Emitter::Kind::sphere || !shines(light, p);
             return may_be_dark || s.density > 0 ? 0.0 : 1.0;
         }),
         .says = "a point in front of a flat light gets no light, where that is small, large, far, seen from its side, "
                 "or faces along an axis of the world"});
    const Statistic finite = property(
        {.id = "L1",
         .what = "answers that are no finite numbers, wherever the point is",
         .violation = of_call<rt::light_sample>([](const LightSample& s) {
             return std::isfinite(s.density + s.distance + rt::dot(s.direction, s.direction)) ? 0.0 : 1.0;
         }),
         .says = "an answer is no finite number where the point is within a sphere, on a lamp or in its plane"});
    return probe_check(
        "anywhere",
        rows_then(rows_of_kinds(96, flat, sphere, within), rows_then(rows_of(24, beside_lamp), rows_of(32, on_lamp))),
        {dark, on, missing, finite});
}

/// The solid angle of spheres of any size that fill up to half of the sky, or next to nothing.
Check large_spheres() {
    const auto inputs = [](Generator& random) {
        Rows rows;
        const std::pair<double, double> sine_and_radius[] = {{0.3, 0.5},   {0.6, 0.5},    {0.8, 0.5},   {0.002, 0.5},
                                                             {0.01, 0.03}, {0.05, 0.001}, {0.05, 1000}, {0.5, 30},
                                                             {0.9, 0.5},   {0.001, 0.5}};
        for (const auto& [sine, radius] : sine_and_radius) {
            Emitter light = emitter(random, Emitter::Kind::sphere);
            light.sphere.radius = radius;
            const vec3 p = light.sphere.center + light.sphere.radius / sine * direction(random);
            for (const Row& u : rows_over_square(16, [](vec2 u) { return row(u); })(random))
                rows.push_back(row(light, p, vec2(u[0], u[1])));
        }
        return rows;
    };
    return probe_check(
        "large_spheres", inputs,
        {mean_of({.id = "L1",
                  .what = "solid angle of spheres, a millimetre to a kilometre large, far and near, over what it is",
                  .number = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2) {
                      const double sine = light.sphere.radius / glm::length(p - light.sphere.center);
                      return s.density > 0 ? 1 / s.density / (2 * rt::pi * (1 - std::sqrt(1 - sine * sine))) : 0.0;
                  }),
                  .delta0 = 0.002,
                  .delta = 0.05,
                  .hint = by_ratio("the solid angle of spheres, small and large, far and near,",
                                   {{2, "is the density halved?"}},
                                   "is the sine of the cone the radius over the distance of the centre?")})});
}

/// The solid angle of a triangle. Source: van Oosterom, Strackee, "The solid angle of a plane triangle", 1983.
double solid_angle(vec3 a, vec3 b, vec3 c) {
    const double x = glm::length(a), y = glm::length(b), z = glm::length(c);
    return 2 * std::atan2(std::abs(rt::dot(a, rt::cross(b, c))),
                          x * y * z + rt::dot(a, b) * z + rt::dot(a, c) * y + rt::dot(b, c) * x);
}

/// Of a flat light from a point before it: of a disc, as a polygon.
double solid_angle(const Emitter& light, vec3 p) {
    const vec3 center = rt::center(light) - p;
    const bool is_quad = light.kind == Emitter::Kind::quad;
    const rt::Frame frame = rt::frame_about(rt::unit(rt::normal(light)));
    const int corners = is_quad ? 4 : 256;
    const auto corner = [&](int k) {
        const double angle = 2 * rt::pi * k / corners;
        if (is_quad)
            return center + (k % 4 < 2 ? 1.0 : -1.0) * light.quad.u + ((k + 1) % 4 < 2 ? 1.0 : -1.0) * light.quad.v;
        return center + light.disc.radius * (std::cos(angle) * frame.x + std::sin(angle) * frame.y);
    };
    double sum = 0;
    for (int k = 0; k < corners; ++k) sum += solid_angle(center, corner(k), corner(k + 1));
    return sum;
}

/// Flat lights of any size, near and far, most of them at a slant.
Statistic solid_angle_of_flat_lights() {
    return mean_of({.id = "L1",
                    .what = "solid angle of flat lights of any size, at a slant, near and far, over what it is",
                    .number = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2) {
                        return s.density > 0 ? 1 / s.density / solid_angle(light, p) : 0.0;
                    }),
                    .delta0 = 0.003,
                    .delta = 0.03,
                    .hint = by_ratio("the solid angle of flat lights at a slant, small and large, near and far,",
                                     {{2, "is the density halved?"}, {0.5, "is the density doubled?"}},
                                     "is the density distance^2 / (cosine at the light * area) there as well?")});
}

Check any_flat_light() {
    const auto inputs = [](Generator& random) {
        Rows rows;
        constexpr int lamps = 24;
        for (int k = 0; k < lamps; ++k) {
            const auto [light, scale] = of_any_size(random, k % 2 == 0 ? Emitter::Kind::quad : Emitter::Kind::disc);
            const double cosine = k % 3 == 0 ? between(random, 0.5, 1) : log_between(random, 0.02, 0.5);
            const vec3 p = rt::center(light) + scale * range_between(random, 1, 100) *
                                                   tilted(random, rt::unit(rt::normal(light)), std::acos(cosine));
            for (const Row& u : rows_over_square(12, [](vec2 u) { return row(u); })(random))
                rows.push_back(row(light, p, vec2(u[0], u[1])));
        }
        return rows;
    };
    return probe_check("any_flat_light", inputs, {solid_angle_of_flat_lights()});
}

/// Each kind of light, of any size, from wherever it shines; flat ones also at a grazing angle.
Check density_of_samples() {
    std::vector<RowWith> kinds;
    std::vector<OwnDensity> densities;
    const auto direction_of = of_call<rt::light_sample>([](const LightSample& s) { return s.direction; });
    for (const auto& [kind, name] : {std::pair(Emitter::Kind::quad, "a quad"), std::pair(Emitter::Kind::disc, "a disc"),
                                     std::pair(Emitter::Kind::sphere, "a sphere")}) {
        const auto from = [](Generator& draw, Emitter::Kind of, double angle, vec2 u) {
            const auto [light, scale] = of_any_size(draw, of);
            const vec3 axis = of == Emitter::Kind::sphere ? direction(draw) : rt::unit(rt::normal(light));
            return row(light, rt::center(light) + scale * between(draw, 1, 3) * tilted(draw, axis, angle), u);
        };
        kinds.emplace_back(
            [=, kind = kind](Generator& draw, vec2 u) { return from(draw, kind, between(draw, 0, 1), u); });
        if (kind != Emitter::Kind::sphere)
            kinds.emplace_back([=, kind = kind](Generator& draw, vec2 u) {
                return from(draw, kind, std::acos(log_between(draw, 5e-3, 0.05)), u);
            });
        const auto density = [kind = kind](const LightSample& s, const Emitter& light, vec3, vec2) {
            return light.kind == kind ? s.density : 0;
        };
        densities.push_back({direction_of, of_call<rt::light_sample>(density), fmt::format("the density on {}", name)});
    }
    return own_density(kinds, densities);
}

}  // namespace

Checks check_light_sample(Generator& random) {
    using Kind = Emitter::Kind;
    Checks checks = {light_sample::many_places(),
                     flat_light(random, Kind::quad, "quad_light"),
                     flat_light(random, Kind::disc, "disc_light"),
                     light_sample::sphere_light(random),
                     anywhere(),
                     large_spheres(),
                     any_flat_light(),
                     light_sample::irradiance(random),
                     density_of_samples(),
                     dark_side()};
    // half of all directions see a flat light from behind
    checks.back().share = 2;
    checks.push_back(shadow_check(random, "quad_penumbra", any_shadow(random, Kind::quad)));
    checks.push_back(shadow_check(random, "disc_penumbra", any_shadow(random, Kind::disc)));
    checks.push_back(shadow_check(random, "sphere_penumbra", any_shadow(random, Kind::sphere)));
    return checks;
}

}  // namespace grade
