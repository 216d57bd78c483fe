#include "asked/point_irradiance.h"
#include "checks/kit/kit.h"
#include "checks/kit/reflection_model.h"
#include "checks/kit/shadow_scene.h"

namespace grade {

namespace {

using rt::Color, rt::PointLight, rt::vec3;

vec3 way_to(const PointLight& light, vec3 p) { return light.directional ? light.position : light.position - p; }

double cosine_to(const PointLight& light, vec3 p, vec3 n) { return rt::dot(n, rt::unit(way_to(light, p))); }

/// The irradiance with another function of the cosine than max(0, cosine).
template <class OfCosine>
auto with_cosine(OfCosine of_cosine) {
    return [=](const PointLight& light, vec3 p, vec3 n) {
        const double r = light.directional ? 1 : glm::length(way_to(light, p));
        return Color(light.intensity * of_cosine(cosine_to(light, p, n)) * std::pow(r, -2.0));
    };
}

/// The right answer times a power of the distance; a directional light has none.
auto times_distance(double power) {
    return [=](Color right, const PointLight& light, vec3 p, vec3) {
        return right * (light.directional ? 1 : std::pow(glm::length(light.position - p), power));
    };
}

Statistic irradiance_by_point() {
    return formula<rt::point_irradiance>(
        {.id = "L2",
         .what = "irradiance, off by",
         .tolerance = 1e-6,
         .right = with_cosine([](double c) { return std::max(0.0, c); }),
         .suspects = {
             {"1/r^2 is missing: the light does not grow fainter with its distance", times_distance(2)},
             {"the light fades with 1/r; expected 1/r^2: divided by r once, or n . d of a vector not of unit length",
              times_distance(1)},
             {"the light fades with 1/r^3; expected 1/r^2: is n . d divided by the length twice?", times_distance(-1)},
             {"the cosine n . d is missing", with_cosine([](double) { return 1.0; })},
             {"the cosine n . d is missing, but for the horizon",
              with_cosine([](double c) { return c > 0 ? 1.0 : 0.0; })},
             {"the cosine counts twice",
              [](Color right, const PointLight& l, vec3 p, vec3 n) { return right * cosine_to(l, p, n); }},
             {"light from below the horizon counts: |n . d| is not max(0, n . d)",
              with_cosine([](double c) { return std::abs(c); })},
             {"light from below the horizon is negative: max(0, n . d) is missing",
              with_cosine([](double c) { return c; })},
             {"the light is on the wrong side of the surface: n . d has the wrong sign",
              with_cosine([](double c) { return std::max(0.0, -c); })},
             {"a factor 4 pi too small: the intensity is in W/sr already",
              [](Color right) { return right / (4 * rt::pi); }},
             {"a directional light is treated as a point light", [](const PointLight& light, vec3 p, vec3 n) {
                  const vec3 d = light.position - p;
                  return Color(light.intensity * std::max(0.0, rt::dot(n, rt::unit(d))) / rt::dot(d, d));
              }}}});
}

}  // namespace

Checks check_point_irradiance(Generator& random) {
    const auto grazing = [](bool directional) {
        return rows_of_decades(lowest_grazing, highest_grazing, 2, [=](Generator& draw, double cosine) {
            const vec3 p = box(draw, -3, 3), n = scene_direction(draw), d = grazing_direction(draw, n, cosine);
            return row(PointLight{directional ? d : p + d, box(draw, 0.5, 20), directional}, p, n);
        });
    };
    const auto inputs = [=](bool directional) {
        const auto any = rows_of(96, [=](Generator& draw) {
            const vec3 p = box(draw, -3, 3), n = scene_direction(draw);
            // some right above, and grazing: a fault there is seen in few pixels
            const double angle = chance(draw, 0.08)  ? 0
                                 : chance(draw, 0.2) ? std::abs(close_to_zero(draw, 1e-4))
                                 : chance(draw, 0.1) ? rt::pi / 2 - close_to_zero(draw, 1e-3)
                                                     : between(draw, 0, chance(draw, 0.75) ? 1.45 : 3);
            const vec3 d = tilted(draw, n, angle);
            const double r = chance(draw, 0.6) ? log_between(draw, 0.3, 10) : range_between(draw, 1e-3, 1000);
            return row(
                PointLight{directional ? d : p + r * d, brightness_of_light(draw) * box(draw, 0.5, 20), directional}, p,
                n);
        });
        const auto channels = rows_of_channels(1, [=](Generator& draw, int, auto change) {
            const vec3 p = box(draw, -3, 3), n = scene_direction(draw), d = tilted(draw, n, between(draw, 0, 1.4));
            return row(PointLight{directional ? d : p + d, change(0, box(draw, 0.5, 20)), directional}, p, n);
        });
        return rows_then(rows_then(any, grazing(directional)), channels);
    };
    const Statistic horizon = property(
        {.id = "L4",
         .what = "irradiance by light below the horizon",
         .violation = of_call<rt::point_irradiance>([](Color irradiance, const PointLight& light, vec3 p, vec3 n) {
             return rt::dot(way_to(light, p), n) < 0 ? rt::largest(irradiance) : 0.0;
         }),
         .says = "light from below the horizon must give exactly 0"});
    return {probe_check("point_light", inputs(false), {irradiance_by_point(), horizon}),
            probe_check("directional_light", inputs(true), {irradiance_by_point(), horizon}),
            shadow_check(random, "lit_floor", any_shadow(random, std::nullopt))};
}

}  // namespace grade
