#include <fmt/format.h>

#include <algorithm>

#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/pictures.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/render_check.h"

namespace grade {

namespace {

using rt::Shutter, rt::vec2, rt::vec3;

Shutter shutter_of(const Row& in) { return argument<0, Shutter, double>(in); }

/// How much of the time that the shutter is open has passed.
double share(const Row& in, const Row& out) {
    return (out[0] - shutter_of(in).open) / (shutter_of(in).close - shutter_of(in).open);
}

Row shutter_row(double open, double close, double u) { return {open, close, u}; }

Check times(Generator& random) {
    const double open = between(random, 0.5, 2) * (chance(random, 0.5) ? 1 : -1), length = between(random, 0.2, 0.4);
    const auto inputs =
        rows_of(1024, [=](Generator& draw) { return shutter_row(open, open + length, between(draw, 0, 1)); });
    Statistic mean = mean_of("M1", "mean time, as a share of the exposure", share, 0.5, 1,
                             by_value("the mean time, as a share of the exposure,",
                                      {{0, "does the shutter close as soon as it opens?"},
                                       {1, "does the shutter open only when it closes?"}},
                                      0.05, "expected times that are uniform between opening and closing"));
    Statistic spread = uniform_in_square("V3", "chi squared of the times per degree of freedom",
        [](const Row& in, const Row& out) { return vec2(share(in, out), 0.5); }, 64, 1,
        by_ratio("the chi squared of the times", {}, "they must be uniform between opening and closing"));
    Statistic inside = property(
        "M1", "times outside the exposure",
        [](const Row& in, const Row& out) { return share(in, out) >= -1e-5 && share(in, out) <= 1 + 1e-5 ? 0.0 : 1.0; },
        0, "a time is before the shutter opens or after it closes");
    inside.hint =
        always("a time is before the shutter opens or after it closes: expected open + a share of (close - open)");
    inside.cause = [=](const Observation& seen) -> std::string {
        const auto all_within = [&](double low, double high) {
            return std::ranges::all_of(seen.outputs,
                                       [&](const Row& out) { return out[0] >= low - 1e-6 && out[0] <= high + 1e-6; });
        };
        if (all_within(0, length)) return "times start at 0; expected open + a share of (close - open)";
        if (all_within(std::min(0.0, open + length), std::max(0.0, open + length)))
            return "times are a share of close; expected open + a share of (close - open)";
        if (all_within(open, open + 1))
            return "up to a second is added to open, whatever close is; expected a share of (close - open)";
        return "";
    };
    mean.cause = spread.cause = [](const Observation& seen) -> std::string {
        double at_ends = 0, as_first = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
            const double s = share(seen.inputs[k], seen.outputs[k]);
            at_ends += std::abs(s) < 1e-6 || std::abs(s - 1) < 1e-6;
            as_first += seen.outputs[k] == seen.outputs[0];
        }
        const double rows = double(seen.inputs.size());
        if (as_first == rows)
            return "there is one time for all samples, the same for every u: each sample has a time of its own";
        if (at_ends > 0.95 * rows)
            return "only the two end times occur, open and close: expected every time between them";
        return "";
    };
    return probe_check("times", inputs, {inside, mean, spread});
}

Check instant() {
    const auto inputs = rows_of(16, [](Generator& random) {
        const double open = between(random, -2, 2);
        return shutter_row(open, open, between(random, 0, 1));
    });
    return probe_check("instant", inputs,
                       {property(
                           "M1", "time from the instant [s]",
                           [](const Row& in, const Row& out) { return std::abs(out[0] - shutter_of(in).open); }, 1e-5,
                           "a shutter that closes as it opens leaves one time")});
}

}  // namespace

Checks check_shutter_time(Generator& random) {
    return {times(random), instant(), streak(random), passing_train(random)};
}

}  // namespace grade
