#include "asked/refracted_direction.h"
#include "checks/kit/glass.h"
#include "checks/kit/kit.h"

namespace grade {

namespace {

using rt::vec3;

/// By Snell's law: the part of d along the surface grows by the ratio of the indices, the rest follows from the length.
/// sign 1: to the other side. Total internal reflection gives the zero vector.
vec3 bent(vec3 d, vec3 n, double ratio, double sign = 1) {
    const vec3 along = ratio * (d - rt::dot(d, n) * n);
    const double rest = 1 - rt::dot(along, along);
    return rest < 0 ? vec3(0) : vec3(along - sign * std::sqrt(rest) * n);
}

bool is_total(vec3 right) { return right == vec3(0); }

/// Below the critical angle, or above it, but not near it.
Row ordinary_boundary(Generator& random, bool total) {
    const vec3 n = scene_direction(random);
    const double low = between(random, 1, 1.2), high = between(random, 1.25, chance(random, 0.2) ? 4 : 2.5);
    const bool up = total || chance(random, 0.5);
    double from = up ? high : low, to = up ? low : high;
    if (total && chance(random, 0.3)) to /= from, from = 1;  // out of air into what is thinner
    const double critical = up ? std::asin(to / from) : rt::pi / 2;
    if (!total && chance(random, 0.1)) to = from;
    const double grazing = std::acos(log_between(random, 1e-3, 0.05));
    const double beyond = chance(random, 0.3) ? log_between(random, 1e-4, 0.05) : between(random, 0.05, 1.5);
    const double angle = total                         ? std::min(critical + beyond, 1.55)
                         : !up && chance(random, 0.15) ? grazing
                                                       : angle_from_axis(random, critical - 0.05);
    return row(-tilted(random, n, angle), n, from, to);
}

Statistic refracted(const std::string& id, const std::string& what, double tolerance) {
    const auto instead_of_zero = [](auto total) {
        return [=](vec3 right, vec3 d, vec3 n, double, double) { return is_total(right) ? vec3(total(d, n)) : right; };
    };
    return formula<rt::refracted_direction>(
        {.id = id,
         .what = what,
         .tolerance = tolerance,
         .right = [](vec3 d, vec3 n, double from, double to) { return bent(d, n, from / to); },
         .suspects = {{"the ratio of the indices is inverted: e = ior_from / ior_to",
                       [](vec3 d, vec3 n, double from, double to) { return bent(d, n, to / from); }},
                      {"the ray stays on its side of the surface: is the root added, or n on the wrong side?",
                       [](vec3 d, vec3 n, double from, double to) { return bent(d, n, from / to, -1); }},
                      {"the ray is not bent", [](vec3 d, vec3, double, double) { return d; }},
                      {"total internal reflection gives nan: the square root's argument is negative there; expected "
                       "the zero vector",
                       instead_of_zero([](vec3, vec3) { return vec3(NAN); })},
                      {"total internal reflection gives the mirrored ray; expected the zero vector",
                       instead_of_zero([](vec3 d, vec3 n) { return d - 2 * rt::dot(d, n) * n; })},
                      {"total internal reflection lets the ray pass; expected the zero vector",
                       instead_of_zero([](vec3 d, vec3) { return d; })},
                      {"the ratio of the indices is inverted, and total internal reflection is not noticed",
                       [](vec3 d, vec3 n, double from, double to) {
                           const vec3 inverted = bent(d, n, to / from);
                           return is_total(inverted) ? vec3(NAN) : inverted;
                       }},
                      {"a ray that leaves the denser side is not bent",
                       [](vec3 right, vec3 d, vec3, double from, double to) { return from > to ? d : right; }}}});
}

}  // namespace

Checks check_refracted_direction(Generator& random) {
    const auto crossing = rows_of(128, [](Generator& draw) { return ordinary_boundary(draw, false); });
    const auto total = rows_of(32, [](Generator& draw) { return ordinary_boundary(draw, true); });
    return {probe_check("snell", crossing, {refracted("F4", "refracted direction, off by", 1e-3)}),
            probe_check("total_reflection", total,
                        {refracted("F3", "direction at total internal reflection, off by", 1e-6)}),
            slab(random, "through_a_slab")};
}

}  // namespace grade
