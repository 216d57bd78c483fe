#include "asked/phong.h"
#include "checks/kit/kit.h"
#include "checks/kit/reflection_model.h"
#include "checks/kit/shadow_scene.h"

namespace grade {

namespace {

using rt::Color, rt::Material, rt::vec3;

auto modelled(Model model) {
    return [=](const Material& m, Color ambient, Color irradiance, vec3 n, vec3 d, vec3 c) {
        const bool ambient_counts = model.ambient || (model.ambient_below && rt::dot(n, d) <= 0);
        return Color((ambient_counts ? m.ambient * ambient : Color(0)) + irradiance * reflected(m, n, d, c, model));
    };
}

}  // namespace

Checks check_phong(Generator& random) {
    const auto any_surface = [](Generator& draw) {
        Material m = any_material(draw);
        m.ambient = box(draw, 0.1, 0.5), m.albedo = box(draw, 0.1, 0.9), m.specular = box(draw, 0.1, 0.9);
        m.shininess = log_between(draw, 2, 60);
        const Color ambient = box(draw, 0, 1), irradiance = brightness_of_light(draw) * box(draw, 1, 5);
        const vec3 n = scene_direction(draw), d = light_direction(draw, n);
        // the viewer near the mirrored light, or anywhere above the surface
        const vec3 c = viewer(draw, n, d);
        return row(m, ambient, irradiance, n, d, c);
    };
    const auto highlights = [](Generator& draw) {
        const auto [m, n, d, c] = extreme_highlight(draw);
        return row(m, Color(0), box(draw, 1, 5), n, d, c);
    };
    const auto flat_highlights = [](Generator& draw) {
        const auto [m, n, d, c] = extreme_highlight(draw, true);
        return row(m, Color(0), box(draw, 1, 5), n, d, c);
    };
    const auto grazing = [](Generator& draw, double cosine) {
        Material m;
        m.albedo = box(draw, 0.1, 0.9);
        const vec3 n = scene_direction(draw);
        return row(m, Color(0), box(draw, 1, 5), n, grazing_direction(draw, n, cosine), n);
    };
    // whatever is black, what is not counts all the same: ambient light alone, a blue lamp, a green highlight
    const auto channels = rows_of_channels(5, [](Generator& draw, int, auto change) {
        Material m;
        m.ambient = change(0, box(draw, 0.1, 0.5)), m.albedo = change(1, box(draw, 0.1, 0.9));
        m.specular = change(2, box(draw, 0.1, 0.9));
        if (chance(draw, 0.2)) m.albedo = m.specular = Color(0);
        m.shininess = chance(draw, 0.3) ? between(draw, 0.1, 1) : log_between(draw, 2, 60);
        const vec3 n = scene_direction(draw), d = tilted(draw, n, between(draw, 0, 1.4));
        const Color ambient = change(3, box(draw, 0.1, 1)), irradiance = change(4, box(draw, 0.1, 5));
        return row(m, ambient, irradiance, n, d, viewer(draw, n, d));
    });
    const auto all_highlights = rows_then(rows_of(64, highlights), rows_of(4, flat_highlights));
    const auto inputs = rows_then(rows_then(rows_of(96, any_surface), all_highlights),
                                  rows_then(rows_of_decades(lowest_grazing, highest_grazing, 2, grazing), channels));
    Formula<rt::phong> radiance{.id = "P4", .what = "radiance, off by", .tolerance = 1e-6, .right = modelled({})};
    for (const ModelMistake& mistake : reflection_mistakes)
        radiance.suspects.push_back({mistake.words, modelled(mistake.model)});
    // a highlight that nobody sees, or Lambert's law would be taken in place of the fragment
    ShadowScene polished = any_shadow(random, std::nullopt);
    polished.specular = 1e-9;
    return {probe_check("reflected_radiance", inputs, {formula(radiance)}),
            shadow_check(random, "lit_floor", polished)};
}

}  // namespace grade
