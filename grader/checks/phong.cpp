#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/reflection_model.h"
#include "checks/kit/shadow_scene.h"

namespace grade {

namespace {

using rt::Color, rt::Material, rt::vec3;

RowFunction modelled(Model model) {
    return of<Material, Color, Color, vec3, vec3, vec3>([=](const Material& m, Color ambient, Color irradiance, vec3 n,
                                                            vec3 d, vec3 c) {
        return Color((model.ambient || (model.ambient_below && rt::dot(n, d) <= 0) ? m.ambient * ambient : Color(0)) +
                     irradiance * reflected(m, n, d, c, model));
    });
}

}  // namespace

Checks check_phong(Generator& random) {
    const auto inputs = rows_of(96, [](Generator& draw) {
        Material m;
        m.ambient = box(draw, 0.1, 0.5), m.albedo = box(draw, 0.1, 0.9), m.specular = box(draw, 0.1, 0.9);
        m.shininess = log_between(draw, 2, 60);
        const Color ambient = box(draw, 0, 1), irradiance = box(draw, 1, 5);
        const vec3 n = direction(draw), d = tilted(draw, n, light_angle(draw));
        // the viewer near the mirrored light, or anywhere above the surface
        const vec3 c = viewer(draw, n, d);
        return row(m, ambient, irradiance, n, d, c);
    });
    std::vector<Suspect> suspects;
    for (const Mistake& mistake : reflection_mistakes()) suspects.push_back({mistake.words, modelled(mistake.model)});
    return {
        probe_check("reflected_radiance", inputs, {formula("P4", "radiance, off by", modelled({}), 1e-4, suspects)}),
        shadow_check(random, "lit_floor", any_shadow(random, std::nullopt))};
}

}  // namespace grade
