#include "checks/light_sample/checks.h"
#include "statistics/closed_forms.h"

namespace grade::light_sample {

using rt::Emitter, rt::LightSample, rt::vec2, rt::vec3;

Check irradiance(Generator& random) {
    const std::array lights = {emitter(random, Emitter::Kind::quad), emitter(random, Emitter::Kind::disc),
                               emitter(random, Emitter::Kind::sphere)};
    struct Surface {
        vec3 p, n;
    };
    std::array<Surface, 3> surfaces;
    const vec3 to_quad = tilted(random, rt::unit(rt::normal(lights[0])), between(random, 0, 0.6));
    surfaces[0] = {lights[0].quad.center + between(random, 1.2, 2) * to_quad,
                   tilted(random, -to_quad, between(random, 0.2, 0.5))};
    const double height = between(random, 0.5, 1.5), distance = lights[2].sphere.radius * between(random, 2, 3),
                 angle = between(random, 0.2, 0.8);
    surfaces[1] = {lights[1].disc.center + height * lights[1].disc.normal, -lights[1].disc.normal};
    const vec3 to_sphere = direction(random);
    surfaces[2] = {lights[2].sphere.center - distance * to_sphere, tilted(random, to_sphere, angle)};
    const double due[] = {quad_irradiance(lights[0].quad, surfaces[0].p, surfaces[0].n),
                          coaxial_disc_irradiance(lights[1].disc.radius, height),
                          sphere_irradiance(lights[2].sphere, surfaces[2].p, surfaces[2].n)};

    const auto inputs = [=](Generator& draws) {
        Rows rows;
        for (std::size_t k = 0; k < 3; ++k)
            for (Row& one : rows_over_square(40, [&](vec2 u) { return row(lights[k], surfaces[k].p, u); })(draws))
                rows.push_back(std::move(one));
        return rows;
    };
    std::vector<Statistic> statistics;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string name = std::array{"a quad", "a disc that faces it", "a sphere"}[k];
        // three times the mean over all rows is the mean over those of one light
        const auto share = [kind = lights[k].kind, n = surfaces[k].n, all = due[k]](const LightSample& s,
                                                                                    const Emitter& light, vec3, vec2) {
            return light.kind == kind && s.density > 0 ? 3 * std::max(0.0, rt::dot(n, s.direction)) / s.density / all
                                                       : 0.0;
        };
        const Statistic mean = mean_of(
            {.id = "L1",
             .what = "irradiance of a surface by " + name + ", over what it must be",
             .number = of_call<rt::light_sample>(share),
             .delta = 0.01,
             .hint = by_ratio("the irradiance by " + name,
                              {{0.5, "is the density twice too large?"}, {2, "is the density twice too small?"}},
                              "is the density per solid angle that of the sample?")});
        statistics.push_back(k < 2 ? find_half_a_percent(mean) : mean);
    }
    return probe_check("irradiance", inputs, statistics);
}

}  // namespace grade::light_sample
