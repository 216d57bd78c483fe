#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/pictures.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/reflection_model.h"

namespace grade {

namespace {

using rt::Color, rt::LightSample, rt::Material, rt::vec3;

/// f(reflected share, radiance, sample) for a model that may be wrong.
RowFunction estimate(
    Model model, std::function<Color(Color, const LightSample&)> over = [](Color c, const LightSample& s) {
        return c / s.density;
    }) {
    return of<Material, Color, LightSample, vec3, vec3>(
        [=](const Material& m, Color radiance, const LightSample& s, vec3 n, vec3 c) {
            return Color(s.density > 0 ? over(reflected(m, n, s.direction, c, model) * radiance, s) : Color(0));
        });
}

}  // namespace

Checks check_direct_light(Generator& random) {
    const auto inputs = rows_of(96, [](Generator& random) {
        Material m;
        m.albedo = box(random, 0.1, 0.9);
        if (chance(random, 0.7)) m.specular = box(random, 0.1, 0.9);
        m.shininess = log_between(random, 2, 60);
        const Color radiance = box(random, 1, 20);
        const vec3 n = direction(random), d = tilted(random, n, light_angle(random));
        const vec3 c = viewer(random, n, d);
        const LightSample sample{d, log_between(random, 0.3, 10),
                                 chance(random, 0.1) ? 0 : log_between(random, 0.05, 20)};
        return row(m, radiance, sample, n, c);
    });
    std::vector<Suspect> suspects = {
        {"the density is ignored: the sample must be divided by it",
         estimate({}, [](Color c, const LightSample&) { return c; })},
        {"the sample is multiplied by its density; expected divided",
         estimate({}, [](Color c, const LightSample& s) { return c * s.density; })},
        {"1/r^2 counts twice: it is part of the density per solid angle",
         estimate({}, [](Color c, const LightSample& s) { return c / (s.density * s.distance * s.distance); })},
        {"the highlight is not divided by the density",
         of<Material, Color, LightSample, vec3, vec3>(
             [](const Material& m, Color l, const LightSample& s, vec3 n, vec3 c) {
                 Model diffuse, highlight;
                 diffuse.highlight = highlight.diffuse = false;
                 return Color(s.density > 0 ? reflected(m, n, s.direction, c, diffuse) * l / s.density +
                                                  reflected(m, n, s.direction, c, highlight) * l
                                            : Color(0));
             })},
        {"a sample with density 0 must add nothing: it gives inf or nan",
         of<Material, Color, LightSample, vec3, vec3>(
             [](const Material& m, Color l, const LightSample& s, vec3 n, vec3 c) {
                 return Color(s.density > 0 ? reflected(m, n, s.direction, c, {}) * l / s.density : Color(NAN));
             })}};
    for (const Mistake& mistake : reflection_mistakes())
        if (mistake.model.ambient) suspects.push_back({mistake.words, estimate(mistake.model)});
    Statistic horizon = property("L4", "radiance of light below the horizon",
        [](const Row& in, const Row& out) {
            const auto sample = argument<2, Material, Color, LightSample, vec3, vec3>(in);
            const auto n = argument<3, Material, Color, LightSample, vec3, vec3>(in);
            return rt::dot(sample.direction, n) < 0 ? rt::largest(from_row<Color>(out)) : 0.0;
        },
        0, "light from below the horizon must give exactly 0, diffuse and highlight");
    return {
        probe_check("one_sample", inputs, {formula("L1", "radiance, off by", estimate({}), 1e-4, suspects), horizon}),
        lit_floor(random), lamp_highlight(random)};
}

}  // namespace grade
