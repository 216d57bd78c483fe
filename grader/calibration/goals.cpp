#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "calibration/tables.h"

namespace grade::calibration {

namespace {

/// How many wrong variants have replays.
long replayed(const Summary& s) {
    return std::ranges::count_if(s.wrong, [](const auto& v) { return v.replayed.gradings > 0; });
}

void of_replayed_right_ones(const Summary& s, GoalTable& goals) {
    goals.row("false failures of the solution, a whole submission, replayed", "at most 1e-4",
              rate(s.solution.failed, s.solution.gradings));
    const auto worst_right = std::ranges::max_element(s.right, {}, failed_rate);
    if (worst_right != s.right.end() && worst_right->replayed.gradings > 0)
        goals.row(
            "false failures of the right variant with the most of them, replayed", "at most 1e-4",
            worst_right->variant->name + ": " + rate(worst_right->replayed.failed, worst_right->replayed.gradings));
}

/// Statistics whose observed rate of rejection is off the nominal one by more than a factor of two.
long outside(const std::vector<Nominal>& rates, double Nominal::*at, bool above) {
    return std::ranges::count_if(rates, [&](const Nominal& n) { return above ? n.*at > 2 : n.*at < 0.5; });
}

void of_nominal_rates(const Summary& s, GoalTable& goals) {
    const long statistics = long(s.nominal.size());
    const auto within = [&](double Nominal::*at) -> std::string {
        if (statistics == 0) return "not run";
        return fmt::format("{} of {} within; {} above, {} below",
                           statistics - outside(s.nominal, at, true) - outside(s.nominal, at, false), statistics,
                           outside(s.nominal, at, true), outside(s.nominal, at, false));
    };
    goals.row("each statistic's rejections, observed over nominal at 1e-2", "0.5 to 2", within(&Nominal::at_2));
    goals.row("the same at 1e-3", "0.5 to 2", within(&Nominal::at_3));
}

void of_real_gradings(const Summary& s, GoalTable& goals) {
    goals.row("false failures, real gradings of whole right submissions", "0 in at least 300",
              rate(s.right_failures, s.right_gradings));
    goals.row("wrong variants failed, real gradings on 3 seeds", "100 %",
              share(total(s.wrong, [](const auto& v) { return v.found; }),
                    total(s.wrong, [](const auto& v) { return v.gradings; })));
    goals.row(
        "wrong variants failed in at least 999 of 1000 replays", "each",
        share(std::ranges::count_if(s.wrong, [](const auto& v) { return failed_rate(v) >= 0.999; }), replayed(s)));
    goals.row("right cause in the first hint, real gradings", "at least 95 %",
              share(total(s.wrong, [](const auto& v) { return v.variant->says.empty() ? 0 : v.named; }),
                    total(s.wrong, [](const auto& v) { return v.variant->says.empty() ? 0 : v.found; })));
}

void of_open_ones(const Summary& s, GoalTable& goals) {
    const double right_open =
        s.solution.gradings > 0 ? 100.0 * double(s.solution.inconclusive) / double(s.solution.gradings) : 0;
    const double wrong_open = replayed(s) > 0 ? 100 * total(s.wrong, open_rate) / double(replayed(s)) : 0;
    goals.row("inconclusive at the default budget: whole solution; wrong variants, replayed", "at most 1 %",
              (s.solution.gradings > 0 ? fmt::format("{:.3f} %", right_open) : "not run") + "; " +
                  (replayed(s) > 0 ? fmt::format("{:.3f} %", wrong_open) : "not run"));
    goals.row("inconclusive, real gradings: whole right submissions; wrong variants", "at most 1 %",
              share(s.right_open, s.right_gradings) + "; " +
                  share(total(s.wrong, [](const auto& v) { return v.open; }),
                        total(s.wrong, [](const auto& v) { return v.gradings; })));
    goals.row("neighbours spoiled, real gradings", "0", share(s.spoiled, s.neighbours));
}

void of_small_ones(const Summary& s, GoalTable& goals) {
    double least = 0;
    std::string which;
    for (const Dose& dose : s.doses) {
        const auto found = std::ranges::find_if(dose.found, [&](const auto& f) {
            return std::all_of(&f, &*dose.found.end(), [](const auto& larger) { return larger.second == 1; });
        });
        const double size =
            found == dose.found.end() ? std::numeric_limits<double>::infinity() : std::stod(found->first);
        if (size > least) least = size, which = dose.variant->fragment;
    }
    if (!s.doses.empty())
        goals.row("smallest bias that is always found, and all larger ones, of the fragment where it is largest",
                  "0.5 %", fmt::format("{:.2g} % ({})", 100 * least, which));
}

}  // namespace

std::string goals(const Summary& s) {
    GoalTable goals;
    of_replayed_right_ones(s, goals);
    of_nominal_rates(s, goals);
    of_real_gradings(s, goals);
    of_open_ones(s, goals);
    of_small_ones(s, goals);
    goals.row("faults in at most 0.05 % of a picture's pixels", "found",
              share(std::ranges::count_if(s.confined, [](const auto& c) { return c.found == c.gradings; }),
                    long(s.confined.size())));
    goals.row("same submission and seed, on a quiet and on a busy machine, with 1 and 7 jobs", "identical records",
              share(s.same_under_load, s.under_load));
    return goals.text();
}

}  // namespace grade::calibration
