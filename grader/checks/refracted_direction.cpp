#include "checks/fragment_checks.h"
#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/kit/glass.h"
#include "checks/kit/probe_check.h"

namespace grade {

namespace {

using rt::vec3;

/// By Snell's law: the part of d along the surface grows by the ratio of the indices, the rest follows from the length.
RowFunction bent(std::function<double(double from, double to)> ratio, double sign, vec3 (*total)(vec3 d, vec3 n)) {
    return of<vec3, vec3, double, double>([=](vec3 d, vec3 n, double from, double to) {
        const vec3 along = ratio(from, to) * (d - rt::dot(d, n) * n);
        const double rest = 1 - rt::dot(along, along);
        return rest < 0 ? total(d, n) : vec3(along - sign * std::sqrt(rest) * n);
    });
}

/// Below the critical angle, or above it, but not near it.
Row ordinary_boundary(Generator& random, bool total) {
    const vec3 n = direction(random);
    const double low = between(random, 1, 1.2), high = between(random, 1.25, 2.5);
    const bool up = total || chance(random, 0.5);
    const double from = up ? high : low, to = up ? low : high;
    const double critical = up ? std::asin(to / from) : rt::pi / 2;
    const double angle = total ? between(random, critical + 0.05, 1.55) : between(random, 0, critical - 0.05);
    return row(-tilted(random, n, angle), n, from, to);
}

}  // namespace

Checks check_refracted_direction(Generator& random) {
    const auto zero = [](vec3, vec3) { return vec3(0); };
    const auto mirror = [](vec3 d, vec3 n) { return vec3(d - 2 * rt::dot(d, n) * n); };
    const auto on = [](vec3 d, vec3) { return d; };
    const auto not_a_number = [](vec3, vec3) { return vec3(NAN); };
    const auto snell = [](double from, double to) { return from / to; };
    const auto inverted = [](double from, double to) { return to / from; };
    const RowFunction right = bent(snell, 1, zero);
    const std::vector<Suspect> suspects = {
        {"the ratio of the indices is inverted: e = ior_from / ior_to", bent(inverted, 1, zero)},
        {"the ray stays on its side of the surface", bent(snell, -1, zero)},
        {"the ray is not bent", of<vec3, vec3, double, double>([](vec3 d, vec3, double, double) { return d; })},
        {"total internal reflection gives nan: the square root's argument is negative there; expected the zero vector",
         bent(snell, 1, not_a_number)},
        {"total internal reflection gives the mirrored ray; expected the zero vector", bent(snell, 1, mirror)},
        {"total internal reflection lets the ray pass; expected the zero vector", bent(snell, 1, on)},
        {"the ratio of the indices is inverted, and total internal reflection is not noticed",
         bent(inverted, 1, not_a_number)},
        {"a ray that leaves the denser side is not bent",
         of<vec3, vec3, double, double>([=](vec3 d, vec3 n, double from, double to) {
             return from > to ? d : from_row<vec3>(right(row(d, n, from, to)));
         })}};
    const auto crossing = rows_of(64, [](Generator& draw) { return ordinary_boundary(draw, false); });
    const auto total = rows_of(32, [](Generator& draw) { return ordinary_boundary(draw, true); });
    return {probe_check("snell", crossing, {formula("F4", "refracted direction, off by", right, 1e-3, suspects)}),
            probe_check("total_reflection", total,
                        {formula("F3", "direction at total internal reflection, off by", right, 1e-6, suspects)}),
            slab(random, "through_a_slab")};
}

}  // namespace grade
