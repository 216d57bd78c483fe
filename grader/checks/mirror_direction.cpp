#include "checks/kit/draw.h"
#include "checks/kit/figures.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"

namespace grade {

namespace {

using rt::vec3;

/// The part along the normal and the part along the surface, each times a factor: -1 and 1 for a mirror.
RowFunction parts(double along_normal, double along_surface) {
    return of<vec3, vec3>([=](vec3 d, vec3 n) {
        const vec3 normal = rt::dot(d, n) * n;
        return vec3(along_normal * normal + along_surface * (d - normal));
    });
}

}  // namespace

Checks check_mirror_direction(Generator& random) {
    const auto inputs = rows_of(64, [](Generator& draw) {
        const vec3 n = direction(draw);
        return row(log_between(draw, 0.1, 10) * direction(draw), n);
    });
    Statistic s =
        formula("W2", "mirrored direction, off by", parts(-1, 1), 1e-4,
                {{"the direction is turned round: r has the wrong sign, it must leave the surface", parts(1, -1)},
                 {"d goes straight on: nothing is mirrored", parts(1, 1)},
                 {"d goes straight back", parts(-1, -1)},
                 {"r runs along the surface: the factor 2 is missing", parts(0, 1)},
                 {"the sign before 2 (d . n) n is wrong", parts(3, 1)},
                 {"r has unit length; expected the length of d",
                  of<vec3, vec3>([](vec3 d, vec3 n) { return rt::unit(d - 2 * rt::dot(d, n) * n); })},
                 {"the normal is taken to be on the viewer's side: it may be on either side of the surface",
                  of<vec3, vec3>([](vec3 d, vec3 n) { return vec3(d + 2 * std::abs(rt::dot(d, n)) * n); })},
                 {"the normal is turned towards the viewer with the wrong sign",
                  of<vec3, vec3>([](vec3 d, vec3 n) { return vec3(d - 2 * std::abs(rt::dot(d, n)) * n); })}});
    return {probe_check("mirrored", inputs, {s}), mirror_image(random)};
}

}  // namespace grade
