#include "checks/fragment_checks.h"
#include "checks/lobe_check.h"

namespace grade {

Checks check_translucency(Generator& random) {
    using rt::vec3;
    const std::vector<std::string> needs = {"phong_lobe", "refracted_direction"};
    const double low = between(random, 1, 1.1), high = between(random, 1.35, 1.8);
    Checks checks;
    struct Case {
        const char* name;
        double angle, from, to;
    };
    for (const Case& c : {Case{"head_on", 0, low, high}, Case{"into_the_denser", between(random, 0.9, 1.2), low, high},
                          Case{"into_the_thinner", between(random, 0.3, 0.5), high, low}}) {
        const double n = between(random, 6, 12), sine = std::sin(c.angle) * c.from / c.to;
        const rt::Frame frame = rt::frame_about(direction(random));
        const vec3 normal = frame.z;
        const vec3 d = std::sin(c.angle) * frame.x - std::cos(c.angle) * normal, axis = sine * frame.x - std::sqrt(1 - sine * sine) * normal;
        const auto inputs = [=](Generator& draws) {
            return repeat(rows_of(1024, [=](Generator& draw) { return row(d, normal, c.from, c.to, n, square(draw)); })(draws));
        };
        checks.push_back(probe_check(c.name, "translucency", needs, inputs, lobe_statistics({axis, -normal, n, "the refracted direction"})));
    }

    const auto total = rows_of(64, [=](Generator& draw) {
        const vec3 normal = direction(draw);
        const vec3 d = -tilted(draw, normal, between(draw, std::asin(low / high) + 0.05, 1.5));
        return row(d, normal, high, low, between(draw, 5, 50), square(draw));
    });
    checks.push_back(probe_check("total_reflection", "translucency", needs, total,
        {property("F3", "weight at total internal reflection", [](const Row&, const Row& out) { return rt::largest(from_row<rt::Scattered>(out).weight); }, 0,
                  "at total internal reflection nothing passes: the weight is 0")}));
    return checks;
}

}  // namespace grade
