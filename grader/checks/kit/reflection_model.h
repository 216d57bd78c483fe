#pragma once

#include "checks/kit/draw.h"
#include "rt/fragments.h"

/// Phong's model, with the choices that are made wrongly, for phong and direct_light.
namespace grade {

struct Model {
    double exponent_factor = 1, exponent_more = 0;  // a becomes factor a + more
    double diffuse_factor = 1;                      // of albedo / pi
    double cosine_power = 1;                        // of the diffuse part
    bool clamp = true;                              // nothing from below the horizon
    bool both_sides = false;                        // |n . d|
    bool highlight_below = false;                   // a highlight from below the horizon
    bool halfway = false;                           // Blinn's half vector
    bool half_not_unit = false;                     // the mean of d and c in its place
    bool about_normal = false;                      // (n . c)^a
    bool highlight_cosine = false;                  // a cosine too many
    bool highlight = true, diffuse = true;
    bool ambient = true, ambient_below = false;     // the latter: where the light is below the horizon
};

/// Reflected radiance over irradiance of a surface that faces the light.
inline rt::Color reflected(const rt::Material& material, rt::vec3 n, rt::vec3 d, rt::vec3 c, const Model& model) {
    double cosine = rt::dot(n, d);
    if (model.both_sides) cosine = std::abs(cosine);
    const bool above = cosine > 0;
    rt::Color sum(0);
    if (model.diffuse && (above || !model.clamp))
        sum += material.albedo / rt::pi *
               (model.diffuse_factor *
                std::copysign(std::pow(std::abs(cosine), model.cosine_power), model.cosine_power > 0 ? cosine : 1));
    if (model.highlight && (above || model.highlight_below)) {
        const rt::vec3 axis = model.about_normal || model.halfway ? n : 2 * cosine * n - d;
        const double along = rt::dot(axis, model.half_not_unit ? 0.5 * (d + c) : model.halfway ? rt::unit(d + c) : c);
        const double exponent = model.exponent_factor * material.shininess + model.exponent_more;
        if (along > 0) sum += material.specular * (std::pow(along, exponent) * (model.highlight_cosine ? cosine : 1));
    }
    return sum;
}

/// Angle of a light from the normal: above the horizon, just below it, or behind.
inline double light_angle(Generator& random) {
    if (chance(random, 0.3)) return rt::pi / 2 - close_to_zero(random, 1e-5);  // grazing
    const double which = between(random, 0, 1);
    return which < 0.65 ? between(random, 0, 1.45) : which < 0.9 ? between(random, 1.65, 1.9) : between(random, 1.9, 3);
}

/// A viewer above the surface, near the mirrored light where it is that high, or anywhere.
inline rt::vec3 viewer(Generator& random, rt::vec3 n, rt::vec3 d) {
    if (chance(random, 0.7))
        for (int attempt = 0; attempt < 20; ++attempt) {
            const double off = chance(random, 0.3) ? std::abs(close_to_zero(random, 1e-3)) : between(random, 0, 0.6);
            const rt::vec3 c = tilted(random, 2 * rt::dot(n, d) * n - d, off);
            if (rt::dot(c, n) > 0.01) return c;
        }
    return tilted(random, n, between(random, 0, 1.5));
}

/// A mistake and its model.
struct Mistake {
    const char* words;
    Model model;
};

inline std::vector<Mistake> reflection_mistakes() {
    std::vector<Mistake> all;
    const auto add = [&](const char* words, auto change) {
        Model model;
        change(model);
        all.push_back({words, model});
    };
    add("a highlight appears where the light is below the horizon", [](Model& m) { m.highlight_below = true; });
    add("the exponent is a + 1; expected a", [](Model& m) { m.exponent_more = 1; });
    add("the exponent is a - 1; expected a", [](Model& m) { m.exponent_more = -1; });
    add("the exponent is 2a; expected a", [](Model& m) { m.exponent_factor = 2; });
    add("the exponent is ignored: the highlight is r . c",
        [](Model& m) { m.exponent_factor = 0, m.exponent_more = 1; });
    add("the highlight is Blinn's (n . h)^a; expected Phong's (r . c)^a", [](Model& m) { m.halfway = true; });
    add("the half vector takes the mirrored light's place, and has not even unit length; expected (r . c)^a",
        [](Model& m) { m.halfway = m.half_not_unit = true; });
    add("the highlight is about the normal; expected about the mirrored light, r = 2 (n . d) n - d",
        [](Model& m) { m.about_normal = true; });
    add("the highlight has a cosine n . d too many", [](Model& m) { m.highlight_cosine = true; });
    add("the highlight is missing", [](Model& m) { m.highlight = false; });
    add("the diffuse part is missing", [](Model& m) { m.diffuse = false; });
    add("1/pi is missing: r_d = albedo / pi", [](Model& m) { m.diffuse_factor = rt::pi; });
    add("1/2pi stands for 1/pi: r_d = albedo / pi", [](Model& m) { m.diffuse_factor = 0.5; });
    add("1/pi counts twice", [](Model& m) { m.diffuse_factor = 1 / rt::pi; });
    add("the cosine n . d is missing from the diffuse part", [](Model& m) { m.cosine_power = 0; });
    add("the cosine n . d counts twice in the diffuse part", [](Model& m) { m.cosine_power = 2; });
    add("the cosine n . d counts once too often", [](Model& m) { m.cosine_power = 2, m.highlight_cosine = true; });
    add("light from below the horizon is negative: max(0, n . d) is missing", [](Model& m) { m.clamp = false; });
    add("light from below the horizon is negative, and its highlight counts",
        [](Model& m) { m.clamp = false, m.highlight_below = true; });
    add("light from below the horizon counts: |n . d| is not max(0, n . d)", [](Model& m) { m.both_sides = true; });
    add("the ambient light is missing", [](Model& m) { m.ambient = false; });
    add("the ambient light is missing", [](Model& m) { m.ambient = false, m.ambient_below = true; });
    return all;
}

}  // namespace grade
