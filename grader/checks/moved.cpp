#include "checks/draw.h"
#include "checks/formula.h"
#include "checks/fragment_checks.h"
#include "checks/probe_check.h"

namespace grade {

Checks check_moved(Generator&) {
    using rt::vec3;
    const auto inputs = rows_of(64, [](Generator& random) {
        const vec3 point = box(random, -3, 3), velocity = box(random, -2, 2);
        return row(point, velocity, between(random, -1, 2));
    });
    const auto law = [](double sign, double power) {
        return of<vec3, vec3, double>([=](vec3 p, vec3 v, double t) { return vec3(p + sign * std::copysign(std::pow(std::abs(t), power), t) * v); });
    };
    const std::vector<Suspect> suspects = {{"the shape moves backwards", law(-1, 1)},
                                           {"the shape does not move", law(0, 1)},
                                           {"the shape is moved by its velocity, whatever the time", of<vec3, vec3, double>([](vec3 p, vec3 v, double) { return p + v; })},
                                           {"the shape stands still before time 0", of<vec3, vec3, double>([](vec3 p, vec3 v, double t) { return vec3(p + std::max(t, 0.0) * v); })}};
    return {probe_check("linear_motion", "moved", {}, inputs, {formula("M1", "point, off by", law(1, 1), 1e-4, suspects)})};
}

}  // namespace grade
