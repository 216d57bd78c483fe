#include "calibration/tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace grade::calibration {

std::string rate(long hits, long all) {
    if (all == 0) return "not run";
    const auto [low, high] = rate_bounds(hits, all);
    if (hits == 0) return fmt::format("0 of {}: below {:.1e} with 95 %", all, high);
    return fmt::format("{} of {} = {:.2e} ({:.1e} to {:.1e})", hits, all, double(hits) / double(all), low, high);
}

std::string share(long hits, long all) {
    return all > 0 ? fmt::format("{} of {} ({:.1f} %)", hits, all, 100.0 * double(hits) / double(all)) : "not run";
}

void GoalTable::row(const std::string& what, const std::string& goal, const std::string& measured) {
    if (measured == "not run" || measured == "not run; not run")
        open_ += fmt::format("* {}: {}\n", what, goal);
    else
        rows_ += fmt::format("| {} | {} | {} |\n", what, goal, measured);
}

std::string GoalTable::text() const {
    return (rows_.empty() ? "" : "| measure | goal | measured |\n|---|---|---|\n" + rows_ + "\n") +
           (open_.empty() ? "" : "Not measured here, and what they must be:\n\n" + open_);
}

double failed_rate(const VariantSummary& v) {
    return v.replayed.gradings > 0 ? double(v.replayed.failed) / double(v.replayed.gradings) : 0;
}
double open_rate(const VariantSummary& v) {
    return v.replayed.gradings > 0 ? double(v.replayed.inconclusive) / double(v.replayed.gradings) : 0;
}

namespace {

/// A table with its heading; without rows a word in its place.
std::string table_or_none(const std::string& heading, const std::string& rows) {
    return rows.empty() ? "None.\n" : heading + rows;
}

}  // namespace

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

std::string dose_list(const Summary& s) {
    std::string text;
    for (const Dose& dose : s.doses) {
        text += fmt::format("* {} ({}):", dose.variant->fragment, dose.variant->what);
        for (const auto& [size, found] : dose.found)
            text += fmt::format(" {:g} %: {:g},", 100 * std::stod(size), found);
        text.back() = '\n';
    }
    return s.doses.empty() ? "Not run.\n" : text;
}

std::string confined_table(const Summary& s) {
    std::string confined;
    for (const Confined& c : s.confined)
        confined += fmt::format("| {} | {} | {} of {} ({:.3f} %) | {} of {} |\n", c.variant->what, c.variant->fragment,
                                c.changed, c.pixels, 100.0 * c.changed / c.pixels, c.found, c.gradings);
    return table_or_none("| variant | fragment | pixels that change in its scene | found |\n|---|---|---|---|\n",
                         confined);
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

std::string hint_table(const Summary& s) {
    long found = 0, bare = 0, by_arguments = 0, by_textbook = 0, by_repair = 0, by_suspect = 0, together = 0;
    double seconds = 0, most = 0;
    std::string dearest = "none";
    for (const VariantSummary& v : s.wrong)
        for (const RealVerdict& hint : v.hints) {
            ++found, bare += hint.is_bare;
            by_arguments += hint.by_arguments, by_textbook += hint.by_textbook, by_repair += hint.by_repair;
            by_suspect += hint.by_suspect;
            together += hint.by_arguments || hint.by_textbook || hint.by_repair || hint.by_suspect;
            seconds += hint.diagnosis_seconds;
            if (hint.diagnosis_seconds > most) most = hint.diagnosis_seconds, dearest = v.variant->name;
        }
    GoalTable goals;
    goals.row("first hint holds a word that names the cause (variants that expect one)", "at least 95 %",
              share(total(s.wrong, [](const auto& v) { return v.variant->says.empty() ? 0 : v.named; }),
                    total(s.wrong, [](const auto& v) { return v.variant->says.empty() ? 0 : v.found; })));
    goals.row("hints that say neither where nor how", "0", share(bare, found));
    goals.row("explained exactly by a change of arguments", "reported", share(by_arguments, found));
    goals.row("by a change of an expression of a textbook's form", "reported", share(by_textbook, found));
    goals.row("put right by a change of one or two of the fragment's own expressions", "reported",
              share(by_repair, found));
    goals.row("by a suspect written by hand", "reported", share(by_suspect, found));
    goals.row("by any of these", "at least 95 %", share(together, found));
    goals.row("CPU seconds that the diagnosis of a fragment takes: mean; most", "at most 1",
              found > 0 ? fmt::format("{:.2f}; {:.2f} ({})", seconds / double(found), most, dearest) : "not run");
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
    return goals.text() + "\nThe first hint of each beside what is wrong, for a reader to judge:\n\n" +
           table_or_none("| variant | what is wrong | hint |\n|---|---|---|\n", hints);
}

}  // namespace grade::calibration
