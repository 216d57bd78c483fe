#include "calibration/report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <thread>

#include "calibration/tables.h"
#include "judging/grading.h"
#include "judging/provenance.h"

namespace grade::calibration {

namespace {

std::string median_ratio(const std::vector<VariantSummary>& rows) {
    std::vector<double> ratios;
    for (const VariantSummary& v : rows)
        if (v.replayed.seconds_per_grading() > 0) ratios.push_back(v.fixed_seconds / v.replayed.seconds_per_grading());
    if (ratios.empty()) return "not run";
    std::ranges::sort(ratios);
    return fmt::format("{:.1f} (quarter points {:.1f} and {:.1f})", ratios[ratios.size() / 2],
                       ratios[ratios.size() / 4], ratios[3 * ratios.size() / 4]);
}

std::string error_against_time(const Summary& s, const std::string& plot) {
    return fmt::format(
               "\n## Error of the verdict against run time\n\nReplayed with other budgets. A verdict is wrong where a "
               "right submission does not pass, or a wrong variant does not fail;\n"
               "inconclusive is wrong here. First with a fixed number of replicates of each check, tested once at the "
               "same rates; then with\nthe grader's own rule, which looks at 8, 16, 32... replicates and stops when "
               "it is certain. The default is at most {}.\n\n{}",
               GradingSettings{}.replicates,
               has_run(s.fixed_budgets) || has_run(s.budgets)
                   ? fmt::format("![probability of a wrong verdict against CPU seconds]({})\n\n", plot)
                   : "") +
           budget_table(s.fixed_budgets, "replicates, fixed") + "\n" +
           budget_table(s.budgets, "most replicates of a statistic");
}

}  // namespace

std::string calibration_report(const Summary& s, const std::string& command, const std::string& plot) {
    std::string text = "# How far verdicts can be trusted\n\n";
    text += fmt::format(
        "Made by `{}` on {:%Y-%m-%d}, {}. {} of {} steps were done; each statistic of each variant has {} replicates "
        "or more,\nand {} statistics with noise share alpha.\n\n",
        command, fmt::localtime(std::time(nullptr)),
        fmt::format("{}, {} threads", name_of_processor(), std::thread::hardware_concurrency()), s.steps_done, s.steps,
        s.least_replicates, s.noisy);
    text +=
        "**Real** gradings run programs, on fresh seeds. **Replays** draw replicates from stores, with replacement, "
        "and decide with the same\n"
        "code; each draws from one of the stores' grading seeds. Rates are given with 95 % bounds.\n\n";
    text += "## What was to be shown\n\n" + goals(s);
    if (s.whole_seconds > 0)
        text += fmt::format("\nA whole right submission takes {:.2f} CPU seconds in its checks (real gradings).\n",
                            s.whole_seconds);
    for (const std::string& failure : s.false_failures) text += "\n* not passed though right: " + failure;
    if (!s.false_failures.empty()) text += "\n";
    text += error_against_time(s, plot);
    text += fmt::format(
        "\n## Stopping early\n\nCost of a fixed number of replicates of the same power, over that of stopping as soon "
        "as it is certain, median over variants:\n"
        "right {}, wrong {}.\n\n",
        median_ratio(s.right), median_ratio(s.wrong));
    text +=
        "## The rules of others\n\nThe same pictures, the mean of 16 replicates against the mean of 64 of the "
        "solution; a rule has found a variant when one of the pictures\n"
        "of its fragment's checks fails. Variants whose fragment draws no picture are left out.\n\n" +
        peer_table(s);
    text += "\n## Sizes of a bias\n\nShare of real gradings that find it.\n\n" + dose_list(s);
    text += "\n## Faults in a few pixels\n\n" + confined_table(s);
    text +=
        "\n## Statistics that do not keep their nominal rate\n\nTests of 16 of the solution's replicates about their "
        "own mean; below 0.5 costs power, above 2 costs false alarms. Those that are off,\n"
        "and those where the solution's mean is more than 4 standard errors beyond Δ0:\n\n" +
        nominal_table(s);
    text += "\n## Hints\n\nReal gradings of wrong variants, each fragment among the solution's.\n\n" + hint_table(s);
    text += "\n## Wrong variants\n\n" + variant_table(s.wrong, true) + "\n## Right variants\n\n" +
            variant_table(s.right, false);
    return text;
}

Plot budget_plot(const Summary& s, int fragments) {
    Plot plot{"Error of the verdict against run time",
              "CPU seconds of a whole submission's checks",
              "probability of a wrong verdict",
              {}};
    const auto add = [&](const std::vector<Budget>& budgets, const std::string& rule, bool dashed) {
        Series right{"right, " + rule, {}, dashed}, wrong{"wrong, " + rule, {}, dashed};
        for (const Budget& b : budgets) {
            const long missed = b.right.gradings - b.right.passed, passed_by = b.wrong.gradings - b.wrong.failed;
            const auto [low, high] = rate_bounds(missed, b.right.gradings);
            const double share = b.right.gradings > 0 ? double(missed) / double(b.right.gradings) : 0;
            // where none was seen there is a bound, and no point
            right.points.push_back({b.right.seconds_per_grading(), share, low, high});
            // as if all fragments were wrong
            wrong.points.push_back({fragments * b.wrong.seconds_per_grading(),
                                    b.wrong.gradings > 0 ? double(passed_by) / double(b.wrong.gradings) : 0});
        }
        plot.series.push_back(std::move(right));
        plot.series.push_back(std::move(wrong));
    };
    add(s.fixed_budgets, "fixed", true);
    add(s.budgets, "as graded", false);
    return plot;
}

}  // namespace grade::calibration
