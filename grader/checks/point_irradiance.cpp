#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/shadow_scene.h"

namespace grade {

namespace {

using rt::Color, rt::PointLight, rt::vec3;

/// intensity cosine^c / distance^r, of a point light; a directional one has no distance.
RowFunction law(double distance_power, std::function<double(double)> of_cosine) {
    return of<PointLight, vec3, vec3>([=](const PointLight& light, vec3 p, vec3 n) {
        const vec3 way = light.directional ? light.position : light.position - p;
        const double r = light.directional ? 1 : glm::length(way);
        return Color(light.intensity * of_cosine(rt::dot(n, rt::unit(way))) * std::pow(r, -distance_power));
    });
}

}  // namespace

Checks check_point_irradiance(Generator& random) {
    const auto clamped = [](double c) { return std::max(0.0, c); };
    const auto inputs = [](bool directional) {
        return rows_of(64, [=](Generator& draw) {
            const vec3 p = box(draw, -3, 3), n = direction(draw);
            // some right above, and grazing: a fault there is seen in few pixels
            const double angle = chance(draw, 0.2)   ? std::abs(close_to_zero(draw, 1e-4))
                                 : chance(draw, 0.1) ? rt::pi / 2 - close_to_zero(draw, 1e-3)
                                                     : between(draw, 0, chance(draw, 0.75) ? 1.45 : 3);
            const vec3 d = tilted(draw, n, angle);
            const double r = log_between(draw, 0.3, 10);
            return row(PointLight{directional ? d : p + r * d, box(draw, 0.5, 20), directional}, p, n);
        });
    };
    const std::vector<Suspect> suspects = {
        {"1/r^2 is missing: the light does not grow fainter with its distance", law(0, clamped)},
        {"the light fades with 1/r; expected 1/r^2", law(1, clamped)},
        {"the light fades with 1/r^3: is n . d taken with a vector that is not of unit length, or the other way round?",
         law(3, clamped)},
        {"the cosine n . d is missing", law(2, [](double) { return 1.0; })},
        {"the cosine n . d is missing, but for the horizon", law(2, [](double c) { return c > 0 ? 1.0 : 0.0; })},
        {"the cosine counts twice", law(2, [](double c) { return c > 0 ? c * c : 0.0; })},
        {"light from below the horizon counts: |n . d| is not max(0, n . d)",
         law(2, [](double c) { return std::abs(c); })},
        {"light from below the horizon is negative: max(0, n . d) is missing", law(2, [](double c) { return c; })},
        {"the light is on the wrong side of the surface: n . d has the wrong sign",
         law(2, [](double c) { return std::max(0.0, -c); })},
        {"a factor 4 pi too small: the intensity is in W/sr already",
         law(2, [](double c) { return std::max(0.0, c) / (4 * rt::pi); })},
        {"a directional light is treated as a point light",
         of<PointLight, vec3, vec3>([](const PointLight& light, vec3 p, vec3 n) {
             const vec3 d = light.position - p;
             return Color(light.intensity * std::max(0.0, rt::dot(n, rt::unit(d))) / rt::dot(d, d));
         })}};
    const RowFunction right = law(2, clamped);
    const Statistic horizon = property("L4", "irradiance by light below the horizon",
        [](const Row& in, const Row& out) {
            const auto light = argument<0, PointLight, vec3, vec3>(in);
            const vec3 p = argument<1, PointLight, vec3, vec3>(in), n = argument<2, PointLight, vec3, vec3>(in);
            const vec3 way = light.directional ? light.position : light.position - p;
            return rt::dot(way, n) < 0 ? rt::largest(from_row<Color>(out)) : 0.0;
        },
        0, "light from below the horizon must give exactly 0");
    return {probe_check("point_light", inputs(false),
                        {formula("L2", "irradiance, off by", right, 1e-4, suspects), horizon}),
            probe_check("directional_light", inputs(true),
                        {formula("L2", "irradiance, off by", right, 1e-4, suspects), horizon}),
            shadow_check(random, "lit_floor", any_shadow(random, std::nullopt))};
}

}  // namespace grade
