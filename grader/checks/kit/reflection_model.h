#pragma once

#include "checks/kit/draw.h"
#include "rt/answers.h"

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
    bool highlight = true;
    bool diffuse = true;
    bool ambient = true;
    bool ambient_below = false;  // where the light is below the horizon
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
    if (chance(random, 0.06)) return 0;
    if (chance(random, 0.3)) return rt::pi / 2 - close_to_zero(random, 1e-5);  // grazing
    const double which = between(random, 0, 1);
    return which < 0.65 ? between(random, 0, 1.45) : which < 0.9 ? between(random, 1.65, 1.9) : between(random, 1.9, 3);
}

/// The direction to a light; along the surface, to the last bit, where the normal is an axis of the world.
inline rt::vec3 light_direction(Generator& random, rt::vec3 n) {
    if (rt::largest(n) == 1 && chance(random, 0.15)) return {n.y, n.z, n.x};
    return tilted(random, n, light_angle(random));
}

/// The direction to a light that grazes the surface: its cosine.
inline rt::vec3 grazing_direction(Generator& random, rt::vec3 n, double cosine) {
    return tilted(random, n, rt::pi / 2 - cosine);
}
constexpr int lowest_grazing = -6, highest_grazing = -2;  // decades of the cosine, of which each is there

/// A viewer above the surface, near the mirrored light where it is that high, or anywhere.
inline rt::vec3 viewer(Generator& random, rt::vec3 n, rt::vec3 d) {
    if (chance(random, 0.06)) return n;
    if (chance(random, 0.06) && rt::dot(n, d) > 0.01) return d;
    if (chance(random, 0.7))
        for (int attempt = 0; attempt < 20; ++attempt) {
            const double off = chance(random, 0.3) ? std::abs(close_to_zero(random, 1e-3)) : between(random, 0, 0.6);
            const rt::vec3 c = tilted(random, 2 * rt::dot(n, d) * n - d, off);
            if (rt::dot(c, n) > 0.01) return c;
        }
    return tilted(random, n, between(random, 0, 1.5));
}

/// How bright a light is, over what is usual in a room.
inline double brightness_of_light(Generator& random) {
    return chance(random, 0.7) ? 1 : range_between(random, 1e-2, 1e4);
}

/// A highlight as the handout promises it: of any exponent from 1 to 10,000, or of 0, seen from within it or from where
/// it is 0 since the viewer looks away from the mirrored light; now and then white. The viewer is above the surface.
struct Highlight {
    rt::Material material;
    rt::vec3 n, to_light, to_viewer;
};
inline Highlight extreme_highlight(Generator& random, bool is_flat = false) {
    Highlight h;
    const bool behind = !is_flat && chance(random, 0.4);
    h.n = scene_direction(random);
    // behind it, a power of a negative number is nan, or a number where the exponent is whole
    const int whole = whole_between(random, 1, 4);
    h.material.shininess = is_flat               ? 0
                           : !behind             ? range_between(random, 1, 1e4)
                           : chance(random, 0.5) ? whole
                                                 : whole + 0.5;
    h.material.specular = chance(random, 0.3) ? rt::Color(1) : box(random, 0.1, 0.9);
    const double widest = is_flat ? 1.2 : 2 / std::sqrt(std::max(h.material.shininess, 1.0));
    rt::vec3 mirrored;
    bool is_seen = false;
    while (!is_seen) {
        h.to_light = tilted(random, h.n, behind ? between(random, 0.8, 1.4) : between(random, 0, 1.2));
        mirrored = 2 * rt::dot(h.n, h.to_light) * h.n - h.to_light;
        h.to_viewer = behind ? tilted(random, h.n, between(random, 0.2, 1.4))
                             : tilted(random, mirrored, between(random, 0, widest));
        is_seen = rt::dot(h.to_viewer, h.n) > 0.01 && (!behind || rt::dot(h.to_viewer, mirrored) < -0.02);
    }
    return h;
}

/// A mistake, as the model that it makes.
struct ModelMistake {
    const char* words;
    Model model;
};

inline const std::vector<ModelMistake> reflection_mistakes = {
    {"a highlight appears where the light is below the horizon", {.highlight_below = true}},
    {"the exponent is a + 1; expected a", {.exponent_more = 1}},
    {"the exponent is a - 1; expected a", {.exponent_more = -1}},
    {"the exponent is 2a; expected a", {.exponent_factor = 2}},
    {"the exponent is ignored: the highlight is r . c", {.exponent_factor = 0, .exponent_more = 1}},
    {"the highlight is Blinn's (n . h)^a; expected Phong's (r . c)^a", {.halfway = true}},
    {"the half vector takes the mirrored light's place, and has not even unit length; expected (r . c)^a",
     {.halfway = true, .half_not_unit = true}},
    {"the highlight is about the normal; expected about the mirrored light, r = 2 (n . d) n - d",
     {.about_normal = true}},
    {"the highlight has a cosine n . d too many", {.highlight_cosine = true}},
    {"the highlight is missing", {.highlight = false}},
    {"the diffuse part is missing", {.diffuse = false}},
    {"1/pi is missing: r_d = albedo / pi", {.diffuse_factor = rt::pi}},
    {"1/2pi stands for 1/pi: r_d = albedo / pi", {.diffuse_factor = 0.5}},
    {"1/pi counts twice", {.diffuse_factor = 1 / rt::pi}},
    {"the cosine n . d is missing from the diffuse part", {.cosine_power = 0}},
    {"the cosine n . d counts twice in the diffuse part", {.cosine_power = 2}},
    {"the cosine n . d counts once too often", {.cosine_power = 2, .highlight_cosine = true}},
    {"light from below the horizon is negative: max(0, n . d) is missing", {.clamp = false}},
    {"light from below the horizon is negative, and its highlight counts", {.clamp = false, .highlight_below = true}},
    {"light from below the horizon counts: |n . d| is not max(0, n . d)", {.both_sides = true}},
    {"the ambient light is missing", {.ambient = false}},
    {"the ambient light is missing", {.ambient = false, .ambient_below = true}},
};

}  // namespace grade
