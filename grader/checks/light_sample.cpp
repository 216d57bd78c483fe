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

/// Lamps from a centimetre to 100 m away, seen along an axis of the world or anyhow; flat ones from behind as well,
/// spheres from the inside, and so close that they fill half of the sky.
Check anywhere() {
    const auto flat = [](Generator& draw) {
        const Emitter light = emitter(draw, chance(draw, 0.5) ? Emitter::Kind::quad : Emitter::Kind::disc);
        const double side = chance(draw, 0.3) ? -1 : 1;
        const vec3 p = rt::center(light) + side * log_between(draw, 1, 100) *
                                               tilted(draw, rt::unit(rt::normal(light)), between(draw, 0, 1));
        return row(light, p, square(draw));
    };
    const auto sphere = [](Generator& draw) {
        const Emitter light = emitter(draw, Emitter::Kind::sphere);
        const vec3 away = chance(draw, 0.5) ? exact_direction(draw) : direction(draw);
        return row(light, light.sphere.center + light.sphere.radius * (1 + log_between(draw, 1e-2, 100)) * away,
                   square(draw));
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
    const Statistic missing =
        mean_of({.id = "L1",
                 .what = "share of the samples in front of a flat light that count",
                 .number = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2) {
                     // of a sphere, samples may lie on its far side
                     const bool may_be_dark = light.kind == Emitter::Kind::sphere || !shines(light, p);
                     return may_be_dark || s.density > 0 ? 1.0 : 0.0;
                 }),
                 .delta0 = 0.001,
                 .delta = 0.01,
                 .hint = always("a point in front of a flat light gets no light, from 1 to 100 m away")});
    return probe_check("anywhere", rows_of_kinds(64, flat, sphere, within), {dark, on, missing});
}

/// The solid angle of spheres that fill up to half of the sky.
Check large_spheres() {
    const auto inputs = [](Generator& random) {
        Rows rows;
        for (const double sine : {0.3, 0.6, 0.8}) {
            Emitter light = emitter(random, Emitter::Kind::sphere);
            const vec3 p = light.sphere.center + light.sphere.radius / sine * direction(random);
            for (const Row& u : rows_over_square(24, [](vec2 u) { return row(u); })(random))
                rows.push_back(row(light, p, vec2(u[0], u[1])));
        }
        return rows;
    };
    return probe_check(
        "large_spheres", inputs,
        {mean_of({.id = "L1",
                  .what = "solid angle of spheres that fill up to half of the sky, over what it is",
                  .number = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2) {
                      const double sine = light.sphere.radius / glm::length(p - light.sphere.center);
                      return s.density > 0 ? 1 / s.density / (2 * rt::pi * (1 - std::sqrt(1 - sine * sine))) : 0.0;
                  }),
                  .delta0 = 0.002,
                  .delta = 0.05,
                  .hint = by_ratio("the solid angle of large spheres", {{2, "is the density halved?"}},
                                   "is the sine of the cone the radius over the distance of the centre?")})});
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
                     light_sample::irradiance(random),
                     dark_side()};
    // half of all directions see a flat light from behind
    checks.back().share = 2;
    checks.push_back(shadow_check(random, "quad_penumbra", any_shadow(random, Kind::quad)));
    checks.push_back(shadow_check(random, "disc_penumbra", any_shadow(random, Kind::disc)));
    checks.push_back(shadow_check(random, "sphere_penumbra", any_shadow(random, Kind::sphere)));
    return checks;
}

}  // namespace grade
