#include <fmt/format.h>

#include "checks/fragment_checks.h"
#include "checks/probe_check.h"
#include "checks/warp.h"

namespace grade {

Checks check_shutter_time(Generator& random) {
    using rt::Shutter;
    const Shutter shutter{between(random, -1, 1), between(random, 1.2, 3)};
    const double length = shutter.close - shutter.open;
    const auto inputs = [shutter](Generator& draws) {
        return repeat(rows_of(1024, [shutter](Generator& draw) { return row(shutter, between(draw, 0, 1)); })(draws));
    };
    const auto share = [=](const Row&, const Row& out) { return (out[0] - shutter.open) / length; };
    Statistic inside = property("M1", "time outside the shutter's interval, in its length",
        [=](const Row& in, const Row& out) { return std::max({0.0, -share(in, out), share(in, out) - 1}); }, 1e-6,
        "times fall before the shutter opens or after it closes");
    Statistic centroid = mean_of("M1", "mean time, as a share of the interval", share, 0.5, 0.5, [](double value, double) {
        if (std::abs(value) < 0.02) return std::string("all times are those of the opening: nothing is blurred");
        if (std::abs(value - 1) < 0.02) return std::string("all times are those of the closing: nothing is blurred");
        return fmt::format("the mean time lies at {:.3g} of the interval; expected the middle: is the opening time added?", value);
    });
    Statistic spread = mean_of("M1", "variance of the time, in interval lengths squared",
        [=](const Row& in, const Row& out) { return rt::sqr(share(in, out) - 0.5); }, 1.0 / 12, 1.0 / 12,
        by_ratio("the variance of the time", {{3, "only the two end times are taken: a double image in place of a streak"}, {0, "all times are the middle one"}}));
    Statistic even = uniform_in_square("M1", "chi-squared of equal parts of the interval",
        [=](const Row& in, const Row& out) { return rt::vec2(share(in, out), 0.5); }, 32, 1, always("the times are not evenly distributed"));
    const auto closed = rows_of(16, [](Generator& draw) {
        const double at = between(draw, -1, 1);
        return row(Shutter{at, at}, between(draw, 0, 1));
    });
    Statistic instant = property("M1", "time off that of a shutter that is open for an instant",
        [](const Row& in, const Row& out) { return std::abs(out[0] - in[0]); }, 1e-6, "a shutter that closes as it opens has one time only");
    return {probe_check("even_in_time", "shutter_time", {}, inputs, {inside, centroid, spread, even, purity()}),
            probe_check("instant", "shutter_time", {}, closed, {instant})};
}

}  // namespace grade
