#include "checks/kit/glass.h"

#include "checks/kit/figures.h"
#include "statistics/closed_forms.h"

namespace grade {

using rt::Quad, rt::vec2, rt::vec3;

Check slab(Generator& random, const std::string& name) {
    const Place place = any_place(random);
    // steep enough that what is nearly Fresnel's formula is off by more than the tolerance, whatever the index is
    const double ior = between(random, 1.5, 1.9), thickness = between(random, 0.6, 0.9), bottom = 0.3;
    const Quad q = any_quad(random, place, 0, 0.7);
    const View view{place({-4.3, 0, 2.5}), place({0.2, 0, 0}), place.axes.z, 28, figure_size};
    const std::string scene = toml(view) + bright_lamp() + material("glass", {{"transmittance", 1}, {"ior", ior}}) +
                              quad("lamp", q) + place.floor("glass", 6, bottom + thickness) +
                              quad("glass", place({0, 0, bottom}), 6.0 * place.axes.x, -6.0 * place.axes.y);
    const vec3 normal = place.axes.z;
    return figure_check(name, scene, "quad behind the glass", [=](const rt::Camera& camera) -> Sight {
        return [=](vec2 film) {
            const vec3 d = view_direction(camera, film);
            const double angle = std::acos(-rt::dot(d, normal)), inside = std::asin(std::sin(angle) / ior);
            const vec3 along = rt::unit(d - rt::dot(d, normal) * normal);
            // sideways at right angles to the ray, towards the normal's side
            const vec3 sideways = -std::cos(angle) * along - std::sin(angle) * normal;
            if (!on_quad(q, camera.eye + thickness * slab_shift(angle, ior) * sideways, d)) return 0.0;
            const double s = rt::sqr(std::sin(angle - inside) / std::sin(angle + inside)),
                         p = rt::sqr(std::tan(angle - inside) / std::tan(angle + inside));
            return rt::sqr(1 - (s + p) / 2);
        };
    });
}

Check invisible_glass(Generator& random) {
    const Place place = any_place(random);
    const double ior = between(random, 1.3, 1.8), around = log_between(random, 0.3, 3);
    const auto glass = [](const std::string& name, double index) {
        return material(name, {{"reflectance", 1}, {"transmittance", 1}, {"ior", index}});
    };
    // paths may be so long that hardly one ends in the glass: that would be noise of few pixels
    const std::string scene = environment(around) + scene_table("[render]", {{"depth", 4096}}) +
                              toml(place.from_above(8, vfov_of(1.2, 8), {48, 24})) + glass("glass", ior) +
                              glass("air", 1 / ior) + sphere("glass", place({-1.2, 0, 0}), 1) +
                              sphere("air", place({1.2, 0, 0}), 1);
    const auto light = [=](const std::string& thing, Region region, const std::string& question) {
        return of_picture(
            {.id = "F3",
             .what = "radiance of " + thing + ", over that of its surroundings",
             .number = [=](const rt::Image& image) { return brightness(region_mean(image, region)) / around; },
             .delta = 0.01,
             .hint = with_value(thing +
                                " where light comes from everywhere alike must be invisible, but its radiance is "
                                "{:.3g} times that of its surroundings: " +
                                question)});
    };
    return render_check(
        "invisible_glass", {scene, 4, "sobol"},
        {light("lossless glass", {2, 2, 20, 20}, "are reflected and refracted shares fresnel and 1 - fresnel?"),
         light("a bubble of air in lossless glass", {26, 2, 20, 20},
               "is all light reflected where none can be refracted?")});
}

}  // namespace grade
