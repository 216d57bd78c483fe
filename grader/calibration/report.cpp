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
               "inconclusive is wrong here. First with a fixed number of repetitions of each check, tested once at the "
               "same rates; then with\nthe grader's own rule, which looks at 8, 16, 32... repetitions and stops when "
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
    std::string text =
        fmt::format("# How far verdicts can be trusted\n\nMade by `{}` on {:%Y-%m-%d}, {}, {} threads. ", command,
                    fmt::localtime(std::time(nullptr)), name_of_processor(), std::thread::hardware_concurrency());
    if (s.steps_done == 0)
        return text + fmt::format(
                          "Nothing is measured yet: none of {} steps is done in this folder. The command without "
                          "`--report` does them.\n\n## What is to be shown\n\n{}",
                          s.steps, goals(s));
    text += fmt::format("{} of {} steps were done; each statistic of each variant was measured {} times or more.\n\n",
                        s.steps_done, s.steps, s.least_replicates);
    text += fmt::format(
        "* A **variant** is a fragment that is wrong on purpose, or right in an unusual way.\n"
        "* **Real** gradings run programs, on fresh seeds.\n"
        "* **Replays** run none: what programs measured once is kept, in stores, and a replay draws from a store, with "
        "replacement, and decides with the same code. Each draws from the stores of one grading seed.\n"
        "* **Alpha** is the rate at which right submissions may fail; {} statistics have noise and share it.\n"
        "* **Δ0** is what pages call right within, **Δ** what it calls wrong beyond.\n"
        "* Rates are given with 95 % bounds.\n\n",
        s.noisy);
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
