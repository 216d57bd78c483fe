#include "calibration/report.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <thread>

#include "judging/grading.h"
#include "judging/provenance.h"

namespace grade::calibration {

namespace {

std::string rate(long hits, long all) {
    if (all == 0) return "not run";
    const auto [low, high] = rate_bounds(hits, all);
    if (hits == 0) return fmt::format("0 of {}: below {:.1e} with 95 %", all, high);
    return fmt::format("{} of {} = {:.2e} ({:.1e} to {:.1e})", hits, all, double(hits) / double(all), low, high);
}

std::string share(long hits, long all) {
    return all > 0 ? fmt::format("{} of {} ({:.1f} %)", hits, all, 100.0 * double(hits) / double(all)) : "not run";
}

template <class Rows, class Value>
auto total(const Rows& rows, Value value) {
    decltype(value(rows[0])) sum{};
    for (const auto& row : rows) sum += value(row);
    return sum;
}

double failed_rate(const VariantSummary& v) {
    return v.replayed.gradings > 0 ? double(v.replayed.failed) / double(v.replayed.gradings) : 0;
}
double open_rate(const VariantSummary& v) {
    return v.replayed.gradings > 0 ? double(v.replayed.inconclusive) / double(v.replayed.gradings) : 0;
}

/// Statistics whose observed rate of rejection is off the nominal one by more than a factor of two.
long outside(const std::vector<Nominal>& rates, double Nominal::*at, bool above) {
    return std::ranges::count_if(rates, [&](const Nominal& n) { return above ? n.*at > 2 : n.*at < 0.5; });
}

std::string goals(const Summary& s) {
    std::string text = "| measure | goal | measured |\n|---|---|---|\n";
    const auto row = [&](const std::string& what, const std::string& goal, const std::string& measured) {
        text += fmt::format("| {} | {} | {} |\n", what, goal, measured);
    };
    row("false failures of the solution, a whole submission, replayed", "at most 1e-4",
        rate(s.solution.failed, s.solution.gradings));
    const auto worst_right = std::ranges::max_element(s.right, {}, failed_rate);
    if (worst_right != s.right.end() && worst_right->replayed.gradings > 0)
        row("false failures of the right variant with the most of them, replayed", "at most 1e-4",
            worst_right->variant->name + ": " + rate(worst_right->replayed.failed, worst_right->replayed.gradings));
    const long statistics = long(s.nominal.size());
    const auto within = [&](double Nominal::*at) -> std::string {
        if (statistics == 0) return "not run";
        return fmt::format("{} of {} within; {} above, {} below",
                           statistics - outside(s.nominal, at, true) - outside(s.nominal, at, false), statistics,
                           outside(s.nominal, at, true), outside(s.nominal, at, false));
    };
    row("each statistic's rejections, observed over nominal at 1e-2", "0.5 to 2", within(&Nominal::at_2));
    row("the same at 1e-3", "0.5 to 2", within(&Nominal::at_3));
    row("false failures, real gradings of whole right submissions", "0 in at least 300",
        rate(s.right_failures, s.right_gradings));
    row("wrong variants failed, real gradings on 3 seeds", "100 %",
        share(total(s.wrong, [](const auto& v) { return v.found; }),
              total(s.wrong, [](const auto& v) { return v.gradings; })));
    const auto replayed = std::ranges::count_if(s.wrong, [](const auto& v) { return v.replayed.gradings > 0; });
    row("wrong variants failed in at least 999 of 1000 replays", "each",
        share(std::ranges::count_if(s.wrong, [](const auto& v) { return failed_rate(v) >= 0.999; }), replayed));
    row("right cause in the first hint, real gradings", "at least 95 %",
        share(total(s.wrong, [](const auto& v) { return v.variant->says.empty() ? 0 : v.named; }),
              total(s.wrong, [](const auto& v) { return v.variant->says.empty() ? 0 : v.found; })));
    const double right_open =
        s.solution.gradings > 0 ? 100.0 * double(s.solution.inconclusive) / double(s.solution.gradings) : 0;
    const double wrong_open = replayed > 0 ? 100 * total(s.wrong, open_rate) / double(replayed) : 0;
    row("inconclusive at the default budget: whole solution; wrong variants, replayed", "at most 1 %",
        (s.solution.gradings > 0 ? fmt::format("{:.3f} %", right_open) : "not run") + "; " +
            (replayed > 0 ? fmt::format("{:.3f} %", wrong_open) : "not run"));
    row("inconclusive, real gradings: whole right submissions; wrong variants", "at most 1 %",
        share(s.right_open, s.right_gradings) + "; " +
            share(total(s.wrong, [](const auto& v) { return v.open; }),
                  total(s.wrong, [](const auto& v) { return v.gradings; })));
    row("neighbours spoiled, real gradings", "0", share(s.spoiled, s.neighbours));
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
        row("smallest bias that is always found, and all larger ones, of the fragment where it is largest", "0.5 %",
            fmt::format("{:.2g} % ({})", 100 * least, which));
    row("faults in at most 0.05 % of a picture's pixels", "found",
        share(std::ranges::count_if(s.confined, [](const auto& c) { return c.found == c.gradings; }),
              long(s.confined.size())));
    row("same submission and seed, on a quiet and on a busy machine, with 1 and 7 jobs", "identical records",
        share(s.same_under_load, s.under_load));
    return text;
}

/// A table with its heading; without rows a word in its place.
std::string table_or_none(const std::string& heading, const std::string& rows) {
    return rows.empty() ? "None.\n" : heading + rows;
}

bool has_run(const std::vector<Budget>& budgets) {
    return std::ranges::any_of(budgets, [](const Budget& b) { return b.right.gradings + b.wrong.gradings > 0; });
}

std::string budget_table(const std::vector<Budget>& budgets, const std::string& heading) {
    if (!has_run(budgets)) return "Not run.\n";
    std::string text = fmt::format(
        "| {} | CPU s, whole solution | not passed | CPU s, a wrong fragment | not failed | the worst one "
        "|\n|---|---|---|---|---|---|\n",
        heading);
    for (const Budget& b : budgets)
        text += fmt::format(
            "| {} | {:.2f} | {} | {:.3f} | {:.2e} | {:.2e} {} |\n", b.replicates, b.right.seconds_per_grading(),
            rate(b.right.gradings - b.right.passed, b.right.gradings), b.wrong.seconds_per_grading(),
            b.wrong.gradings > 0 ? 1 - double(b.wrong.failed) / double(b.wrong.gradings) : 0, b.worst_wrong, b.worst);
    return text;
}

std::string variant_table(const std::vector<VariantSummary>& rows, bool wrong) {
    std::string text =
        wrong ? "| variant | fragment | failed | cause named | replays failed | inconclusive | CPU s | fixed / "
                "sequential | z-test | mean difference | global mean |\n|---|---|---|---|---|---|---|---|---|---|---|\n"
              : "| variant | fragment | failed | replays failed | inconclusive | CPU s | fixed / sequential | z-test | "
                "mean difference | global mean |\n|---|---|---|---|---|---|---|---|---|---|\n";
    if (std::ranges::none_of(rows, [](const auto& v) { return v.gradings > 0 || v.replayed.gradings > 0; }))
        return "Not run.\n";
    for (const VariantSummary& v : rows) {
        const auto peer = [&](bool passes) {
            return v.pictures == 0 ? "–" : passes ? (wrong ? "missed" : "passed") : (wrong ? "found" : "**failed**");
        };
        const double seconds = v.replayed.seconds_per_grading();
        text += fmt::format("| {} | {} | {} of {} |", v.variant->name.substr(v.variant->name.find('/') + 1),
                            v.variant->fragment, v.found, v.gradings);
        if (wrong) text += v.variant->says.empty() ? " – |" : fmt::format(" {} of {} |", v.named, v.found);
        text += fmt::format(" {:.5g} | {:.2g} | {:.3f} | {} | {} | {} | {} |\n", failed_rate(v), open_rate(v), seconds,
                            seconds > 0 ? fmt::format("{:.1f}", v.fixed_seconds / seconds) : "–", peer(v.peers.z_test),
                            peer(v.peers.mean_difference), peer(v.peers.global_mean));
    }
    return text;
}

/// How often each rule is right, over variants that have pictures.
std::string peer_table(const Summary& s) {
    const auto shown = [](const std::vector<VariantSummary>& rows) {
        return std::ranges::count_if(rows, [](const auto& v) { return v.pictures > 0; });
    };
    const auto caught = [](const std::vector<VariantSummary>& rows, bool PeerRules::*rule) {
        return std::ranges::count_if(rows, [&](const auto& v) { return v.pictures > 0 && !(v.peers.*rule); });
    };
    const auto ours = [](const std::vector<VariantSummary>& rows) {
        return std::ranges::count_if(rows, [](const auto& v) { return v.pictures > 0 && v.found > 0; });
    };
    std::string text = "| rule | wrong variants found | right variants failed |\n|---|---|---|\n";
    const auto row = [&](const char* what, bool PeerRules::*rule) {
        text += fmt::format("| {} | {} | {} |\n", what, share(caught(s.wrong, rule), shown(s.wrong)),
                            share(caught(s.right, rule), shown(s.right)));
    };
    row("z-test of each pixel, 99.75 % must pass", &PeerRules::z_test);
    row("mean absolute difference below 0.1", &PeerRules::mean_difference);
    row("mean of the picture within 2.5 %", &PeerRules::global_mean);
    text += fmt::format("| this grader | {} | {} |\n", share(ours(s.wrong), shown(s.wrong)),
                        share(ours(s.right), shown(s.right)));
    return text;
}

std::string nominal_table(const Summary& s) {
    const std::string heading =
        "| check | statistic | at 1e-2 | at 1e-3 | solution's deviation / Δ | beyond Δ0 [standard errors] "
        "|\n|---|---|---|---|---|---|\n";
    std::string text;
    for (const Nominal& n : s.nominal) {
        const bool off = n.at_2 > 2 || n.at_2 < 0.5 || n.at_3 > 2 || n.at_3 < 0.5 || n.tilt > 4;
        if (off)
            text += fmt::format("| {} | {} | {:.2f} | {:.2f} | {:.3f} | {:.1f} |\n", n.check, n.what, n.at_2, n.at_3,
                                n.bias, n.tilt);
    }
    return table_or_none(heading, text);
}

/// How good hints are, over real gradings of wrong variants that were found.
std::string hint_table(const Summary& s) {
    long found = 0, bare = 0, by_arguments = 0, by_steps = 0, by_suspect = 0, together = 0;
    double seconds = 0, most = 0;
    std::string dearest = "none";
    for (const VariantSummary& v : s.wrong)
        for (const RealVerdict& hint : v.hints) {
            ++found, bare += hint.is_bare;
            by_arguments += hint.by_arguments, by_steps += hint.by_steps, by_suspect += hint.by_suspect;
            together += hint.by_arguments || hint.by_steps || hint.by_suspect;
            seconds += hint.diagnosis_seconds;
            if (hint.diagnosis_seconds > most) most = hint.diagnosis_seconds, dearest = v.variant->name;
        }
    std::string text = "| measure | goal | measured |\n|---|---|---|\n";
    const auto row = [&](const char* what, const char* goal, const std::string& measured) {
        text += fmt::format("| {} | {} | {} |\n", what, goal, measured);
    };
    row("first hint holds a word that names the cause (variants that expect one)", "at least 95 %",
        share(total(s.wrong, [](const auto& v) { return v.variant->says.empty() ? 0 : v.named; }),
              total(s.wrong, [](const auto& v) { return v.variant->says.empty() ? 0 : v.found; })));
    row("hints that say neither where nor how", "0", share(bare, found));
    row("explained exactly by a change of arguments", "reported", share(by_arguments, found));
    row("by a change of an expression of a textbook's form", "reported", share(by_steps, found));
    row("by a suspect written by hand", "reported", share(by_suspect, found));
    row("by any of these", "at least 95 %", share(together, found));
    row("CPU seconds that the diagnosis of a fragment takes: mean; most", "at most 1",
        found > 0 ? fmt::format("{:.2f}; {:.2f} ({})", seconds / double(found), most, dearest) : "not run");
    text += "\nThe first hint of each beside what is wrong, for a reader to judge:\n\n";
    std::string hints;
    const auto in_cell = [](const std::string& words) {
        std::string cell;
        for (const char c : words) cell += c == '\n' ? "<br>" : c == '|' ? "\\|" : std::string(1, c);
        return cell;
    };
    for (const VariantSummary& v : s.wrong)
        if (!v.hints.empty())
            hints += fmt::format("| {} | {} | {} |\n", v.variant->name.substr(v.variant->name.find('/') + 1),
                                 in_cell(v.variant->what), in_cell(v.hints.front().message));
    return text + table_or_none("| variant | what is wrong | hint |\n|---|---|---|\n", hints);
}

std::string median_ratio(const std::vector<VariantSummary>& rows) {
    std::vector<double> ratios;
    for (const VariantSummary& v : rows)
        if (v.replayed.seconds_per_grading() > 0) ratios.push_back(v.fixed_seconds / v.replayed.seconds_per_grading());
    if (ratios.empty()) return "not run";
    std::ranges::sort(ratios);
    return fmt::format("{:.1f} (quarter points {:.1f} and {:.1f})", ratios[ratios.size() / 2],
                       ratios[ratios.size() / 4], ratios[3 * ratios.size() / 4]);
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
    text += fmt::format(
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
    text += "\n## Sizes of a bias\n\nShare of real gradings that find it.\n\n";
    if (s.doses.empty()) text += "Not run.\n";
    for (const Dose& dose : s.doses) {
        text += fmt::format("* {} ({}):", dose.variant->fragment, dose.variant->what);
        for (const auto& [size, found] : dose.found)
            text += fmt::format(" {:g} %: {:g},", 100 * std::stod(size), found);
        text.back() = '\n';
    }
    std::string confined;
    for (const Confined& c : s.confined)
        confined += fmt::format("| {} | {} | {} of {} ({:.3f} %) | {} of {} |\n", c.variant->what, c.variant->fragment,
                                c.changed, c.pixels, 100.0 * c.changed / c.pixels, c.found, c.gradings);
    text += "\n## Faults in a few pixels\n\n" +
            table_or_none("| variant | fragment | pixels that change in its scene | found |\n|---|---|---|---|\n",
                          confined);
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
