#include "asked/fresnel_dielectric.h"
#include "checks/kit/glass.h"
#include "checks/kit/kit.h"

namespace grade {

namespace {

/// Fresnel's formulas in the angles: for s (sin(a - b) / sin(a + b))^2, for p (tan(a - b) / tan(a + b))^2.
double fresnel(double cosine, double from, double to, double share_s, double share_p, double total) {
    const double a = std::acos(cosine), sine = std::sin(a) * from / to;
    if (sine > 1) return total;
    if (from == to) return 0;
    const double b = std::asin(sine);
    if (a < 1e-6) return (share_s + share_p) * rt::sqr((from - to) / (from + to));
    return share_s * rt::sqr(std::sin(a - b) / std::sin(a + b)) + share_p * rt::sqr(std::tan(a - b) / std::tan(a + b));
}

auto law(double share_s, double share_p, double total) {
    return [=](double cosine, double from, double to) { return fresnel(cosine, from, to, share_s, share_p, total); };
}

double schlick(double cosine, double from, double to) {
    const double r0 = rt::sqr((from - to) / (from + to));
    return r0 + (1 - r0) * std::pow(1 - cosine, 5);
}

}  // namespace

Checks check_fresnel_dielectric(Generator& random) {
    const auto any_boundary = [](Generator& draw) {
        const double low = between(draw, 1, 1.2), high = between(draw, 1.3, chance(draw, 0.2) ? 4 : 2.5);
        const bool up = chance(draw, 0.5);
        const double from = up ? high : low, to = chance(draw, 0.05) ? from : up ? low : high;
        double cosine;
        do cosine = chance(draw, 0.1) ? 1 : between(draw, 0.02, 1);
        while (std::abs(1 - rt::sqr(from / to) * (1 - cosine * cosine)) < 0.01 && from != to);
        // some close to the critical angle, on either side: a fault there is seen in few pixels
        if (from > to && chance(draw, 0.6))
            cosine = std::sqrt(1 - (1 - close_to_zero(draw, 3e-5)) * rt::sqr(to / from));
        return row(cosine, from, to);
    };
    // out of air into what is thinner, and along a surface between equal indices
    const auto thinner = [](Generator& draw) {
        const double to = between(draw, 0.5, 0.9);
        return row(between(draw, 0.05, 0.95) * std::sqrt(1 - to * to), 1.0, to);
    };
    const auto equal = [](Generator& draw) {
        const double n = between(draw, 1, 2);
        return row(chance(draw, 0.5) ? 0 : between(draw, 0, 1), n, n);
    };
    // along the surface all is reflected, and nearly equal indices are not equal
    const auto grazing = [](Generator& draw) {
        const double low = between(draw, 1, 1.2), high = between(draw, 1.3, 2.5);
        return row(chance(draw, 0.3) ? 0 : log_between(draw, 1e-4, 0.05), low, high);
    };
    const auto nearly_equal = [](Generator& draw) {
        const double n = between(draw, 1, 2);
        return row(between(draw, 0.3, 0.6), n, n * (1 + log_between(draw, 1e-3, 2e-2)));
    };
    const auto inputs = rows_then(rows_of(192, any_boundary), rows_of_kinds(16, thinner, equal, grazing, nearly_equal));
    const Statistic reflectance = formula<rt::fresnel_dielectric>(
        {.id = "F3",
         .what = "reflectance, off by",
         .tolerance = 1e-3,
         .right = law(0.5, 0.5, 1),
         .suspects = {
             {"total internal reflection gives 0; expected 1", law(0.5, 0.5, 0)},
             {"total internal reflection gives nan; expected 1", law(0.5, 0.5, NAN)},
             {"the indices are inverted: ior_from and ior_to are exchanged",
              [](double c, double from, double to) { return fresnel(c, to, from, 0.5, 0.5, 1); }},
             {"the factor 1/2 is missing: unpolarised light is the mean of s and p", law(1, 1, 1)},
             {"only s-polarised light is counted: expected the mean of s and p", law(1, 0, 1)},
             {"only p-polarised light is counted: expected the mean of s and p", law(0, 1, 1)},
             {"the transmitted share is returned; expected the reflected one", [](double right) { return 1 - right; }},
             {"this is Schlick's approximation; expected Fresnel's formula", schlick},
             {"this is Schlick's approximation; expected Fresnel's formula",
              [](double right, double c, double from, double to) {
                  return right == 1 || from == to ? right : schlick(c, from, to);
              }}}});
    return {probe_check("reflectance", inputs, {reflectance}), slab(random, "light_through_a_slab"),
            invisible_glass(random)};
}

}  // namespace grade
