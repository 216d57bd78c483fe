#include "checks/fragment_checks.h"
#include "checks/probe_check.h"
#include "checks/warp.h"

namespace grade {

Checks check_free_flight(Generator& random) {
    Checks checks;
    for (const char* name : {"thin_medium", "thick_medium"}) {
        const double s = checks.empty() ? between(random, 0.15, 0.5) : between(random, 3, 8);
        const auto inputs = [s](Generator& draws) {
            return repeat(rows_of(1024, [s](Generator& draw) { return row(s, between(draw, 0, 1)); })(draws));
        };
        Statistic forward = property("B1", "distances below 0 [m]", [](const Row&, const Row& out) { return std::max(0.0, -out[0]); }, 0,
                                     "distances are negative: the sign of the logarithm");
        Statistic mean = mean_of("B1", "mean distance times extinction", [s](const Row&, const Row& out) { return s * out[0]; }, 1, 1,
                                 by_ratio("the mean distance", {{s * s, "it is proportional to the extinction; expected its inverse"},
                                                                {s, "the extinction is not used"},
                                                                {0.5, "distances are uniform; expected exponential"},
                                                                {std::log10(std::exp(1.0)), "log10 stands for the natural logarithm"}}));
        Statistic law = uniform_in_square("B1", "chi-squared of exp(-extinction distance)",
            [s](const Row&, const Row& out) { return rt::vec2(std::exp(-s * out[0]), 0.5); }, 32, 1,
            always("the distances are not distributed as s exp(-s t)"));
        checks.push_back(probe_check(name, "free_flight", {}, inputs, {mean, forward, law, purity()}));
    }
    return checks;
}

}  // namespace grade
