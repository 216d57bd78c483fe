#include "checks/fragment_checks.h"
#include "checks/lobe_check.h"

namespace grade {

Checks check_glossy_reflection(Generator& random) {
    using rt::vec3;
    Checks checks;
    for (const char* name : {"head_on", "at_an_angle"}) {
        const double angle = checks.empty() ? 0 : between(random, 0.9, 1.2), n = between(random, 6, 12);
        const vec3 normal = direction(random), d = -tilted(random, normal, angle);
        const vec3 axis = rt::unit(d - 2 * rt::dot(d, normal) * normal);
        const auto inputs = [=](Generator& draws) {
            return repeat(rows_of(1024, [=](Generator& draw) { return row(d, normal, n, square(draw)); })(draws));
        };
        checks.push_back(probe_check(name, "glossy_reflection", {"phong_lobe", "mirror_direction"}, inputs,
                                     lobe_statistics({axis, normal, n, "the mirror direction"})));
    }
    return checks;
}

}  // namespace grade
