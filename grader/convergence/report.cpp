#include "convergence/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/escape.h"

namespace grade::convergence {

namespace {

/// Cells of words; the first one is the head.
using Cells = std::vector<std::vector<std::string>>;

std::string with_interval(double value, double low, double high, const char* format) {
    const std::string number = fmt::format(fmt::runtime(format), value);
    if (!(high > low)) return number;
    return fmt::format("{} ({} to {})", number, fmt::format(fmt::runtime(format), low),
                       fmt::format(fmt::runtime(format), high));
}

std::string words(const std::optional<Ratio>& ratio) {
    return ratio ? with_interval(ratio->value, ratio->low, ratio->high, "{:.3g}") : "not reached";
}

std::string root(double square) { return square > 0 ? fmt::format("{:.3g}", std::sqrt(square)) : "0"; }

std::string bias_of(const Curve& curve) {
    if (!curve.bias) return "no noise to average away";
    const auto [value, se] = *curve.bias;
    if (!curve.bias->is_positive()) return fmt::format("< {}", root(std::max(value, 0.0) + 4 * se));
    return fmt::format("{} ({} to {})", root(value), root(value - 1.96 * se), root(value + 1.96 * se));
}

const char* whose(Who who) { return who == Who::submission ? "yours" : "right"; }

/// Of a curve, in a report: its pattern, and whose it is where there are both.
std::string name_of(const SceneRecord& scene, const Curve& curve) {
    if (scene.comparisons.empty()) return curve.sampler;
    return curve.sampler + (curve.who == Who::submission ? ", yours" : ", the right one");
}

/// The result of each curve; the long form, for pages, has relative errors and rays as well, and heads in full words.
Cells curve_rows(const SceneRecord& scene, bool is_long) {
    Cells rows{
        {"", "sampler", "slope", "expected", "samples", "error", "CPU s", "efficiency", "s to 64", "to 1024", "bias"}};
    if (is_long)
        rows[0] = {"pattern",         "slope",
                   "slope in theory", "samples a pixel",
                   "error",           "error / brightness",
                   "million rays",    "CPU seconds",
                   "efficiency",      "CPU seconds to the error of 64 random samples",
                   "to that of 1024", "bias"};
    for (const Curve& curve : scene.curves) {
        std::vector<std::string> row{whose(curve.who), curve.sampler};
        if (is_long) row = {name_of(scene, curve)};
        const Fit& fit = curve.fit;
        row.push_back(fit.good ? with_interval(fit.order, fit.low, fit.high, "{:.2f}") : "none");
        row.push_back(expected_order(curve.sampler));
        if (curve.levels.empty()) continue;
        const Level& last = curve.levels.back();
        row.insert(row.end(), {fmt::format("{}", last.samples), root(last.mse())});
        if (is_long) row.insert(row.end(), {root(last.relative()), fmt::format("{:.3g}", 1e-6 * last.rays())});
        row.insert(row.end(), {fmt::format("{:.3g}", last.seconds()),
                               last.mse() > 0 ? fmt::format("{:.3g}", last.efficiency()) : "no error"});
        for (const auto& error : scene.errors) {
            const auto seconds = error ? curve.seconds_for(*error) : std::nullopt;
            row.push_back(seconds ? fmt::format("{:.3g}", seconds->value) : error ? "not reached" : "unknown");
        }
        row.push_back(bias_of(curve));
        rows.push_back(row);
    }
    return rows;
}

/// "With 16 samples a pixel the pattern orthogonal has the least error, 0.0032; independent points have 0.0073."
std::string result(const SceneRecord& scene) {
    const Who who = scene.comparisons.empty() ? scene.curves.front().who : Who::submission;
    const Curve* best = nullptr;
    for (const Curve& curve : scene.curves)
        if (curve.who == who && !curve.levels.empty() &&
            (!best || curve.levels.back().mse() < best->levels.back().mse()))
            best = &curve;
    if (!best) return {};
    const Level& last = best->levels.back();
    std::string text = fmt::format("With {} samples a pixel the pattern `{}` has the least error{}, {}", last.samples,
                                   best->sampler, who == Who::submission ? " of yours" : "", root(last.mse()));
    const Curve* random = scene.find(who, "random");
    if (random && random != best && !random->levels.empty())
        text += fmt::format("; independent points, `random`, have {}", root(random->levels.back().mse()));
    text += ".";
    for (const Comparison& c : scene.comparisons)
        if (c.sampler == best->sampler && c.mse_at_equal_time)
            text += fmt::format(" In the same time, its squared error is {} times the right one's.",
                                words(c.mse_at_equal_time));
    return text;
}

Cells comparison_rows(const SceneRecord& scene) {
    Cells rows{{"yours / the right one", "error^2 at equal time", "time to the error of 64", "of 1024"}};
    for (const Comparison& c : scene.comparisons)
        rows.push_back({c.sampler, words(c.mse_at_equal_time), words(c.time_at_error[0]), words(c.time_at_error[1])});
    return rows;
}

/// What a bias does; empty: none is shown.
std::string warning(const SceneRecord& scene) {
    if (!scene.fault.empty()) return fmt::format("Your program breaks down: {}", printable(scene.fault, 200));
    const Curve* curve = scene.biased();
    if (!curve) return {};
    std::string text = fmt::format("Biased: with {}, {} error does not fall below a plateau of {}", curve->sampler,
                                   curve->who == Who::submission ? "your" : "the right one's", bias_of(*curve));
    const Fit& fit = curve->fit;
    if (fit.good && fit.plateau > 0 && fit.order < 0) {
        const double samples = std::pow(fit.plateau / fit.v, 1 / (2 * fit.order));
        text += samples < 1 ? "; already the noise of a single sample is less"
                            : fmt::format("; from about {:.2g} samples on, that is more than its noise", samples);
    }
    return text + ". More samples do not help: the mean picture is another one than the right one.";
}

std::string about_reference(const SceneRecord& scene) {
    return fmt::format("{} x {} pixels; compared with the right picture: 2 x {} samples, error {:.2g}", scene.size.x,
                       scene.size.y, scene.reference_samples, scene.reference_noise);
}

std::string aligned(const Cells& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k) {
            if (widths.size() <= k) widths.push_back(0);
            widths[k] = std::max(widths[k], row[k].size());
        }
    std::string text;
    for (const auto& row : rows) {
        std::string line = " ";
        for (std::size_t k = 0; k < row.size(); ++k) line += fmt::format(" {:<{}} ", row[k], widths[k]);
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string markdown(const Cells& rows) {
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        text += fmt::format("| {} |\n", fmt::join(rows[i], " | "));
        if (i > 0) continue;
        text += "|";
        for (std::size_t k = 0; k < rows[i].size(); ++k) text += "---|";
        text += "\n";
    }
    return text + "\n";
}

/// What the columns mean.
constexpr const char* legend =
    "Error: the root of the mean squared difference from the right picture.\n"
    "Slope: of the error against the samples, from the fit error^2 = b^2 + v N^(-2q), with its 95 % interval.\n"
    "Efficiency: 1 / (error^2 x CPU s). s to 64, to 1024: CPU time to the error of so many independent samples a "
    "pixel.\n"
    "Bias: error that is left when all noise is averaged away; <: none is shown, and none above that is likely.\n";

/// How it was measured, what words mean, and what theory expects.
std::string methods(const std::string& command) {
    Cells orders{{"pattern", "slope of the error on an edge in 2D", "for a smooth function in 2D"}};
    for (const ExpectedOrder& order : expected_orders())
        orders.push_back({order.sampler, order.edge ? fmt::format("{:.2f}", *order.edge) : "no law",
                          order.smooth ? fmt::format("{:.2f}", *order.smooth) : "no law"});
    return "## What the words mean\n\n"
           "* Error: the root of the mean squared difference from the right picture.\n"
           "* Slope: of the error against the samples, both logarithmic, with its 95 % interval: -0.5 means that four "
           "times the samples halve the error. From the fit error^2 = b^2 + v N^(-2q).\n"
           "* Efficiency: 1 / (error^2 x CPU seconds).\n"
           "* CPU seconds to the error of 64 random samples: what this pattern takes for as small an error as 64 "
           "independent samples a pixel have.\n"
           "* Bias: error that is left when all noise is averaged away. < 0.002: none is shown, and none above 0.002 "
           "is likely.\n"
           "* CPU seconds are of rendering alone, with fragments linked as the grader does it; compare them within one "
           "run only.\n\n"
           "## What theory expects\n\n"
           "A picture has edges and smooth parts, and where many dimensions interact, patterns that stratify two at a "
           "time fall back towards -0.50. Edges along the axes behave otherwise.\n\n" +
           markdown(orders) + fmt::format("Again: `{}`\n", command);
}

}  // namespace

std::string table(const ConvergenceRecord& record, bool color) {
    std::string text;
    for (const SceneRecord& scene : record.scenes) {
        text += fmt::format("{}{}{}: {}\n", color ? "\033[1m" : "", scene.name, color ? "\033[0m" : "",
                            about_reference(scene));
        if (!scene.curves.empty()) text += aligned(curve_rows(scene, false));
        if (!scene.comparisons.empty()) text += "\n" + aligned(comparison_rows(scene));
        if (const std::string words = warning(scene); !words.empty())
            text += fmt::format("  {}{}{}\n", color ? "\033[31m" : "", words, color ? "\033[0m" : "");
        text += "\n";
    }
    if (!record.note.empty()) text += record.note + "\n";
    return text + legend;
}

std::string report(const ConvergenceRecord& record) {
    std::string text = fmt::format("# Error against run time: {}\n\n", record.submission);
    if (!record.note.empty()) text += record.note + "\n\n";
    for (const SceneRecord& scene : record.scenes) {
        text += fmt::format("## {}\n\n", scene.name);
        if (const std::string words = warning(scene); !words.empty()) text += fmt::format("**{}**\n\n", words);
        if (!scene.curves.empty()) text += result(scene) + "\n\n";
        for (const Against against : {Against::seconds, Against::rays})
            if (!scene.curves.empty())
                text += fmt::format("![error of {} against {}]({})\n", scene.name,
                                    against == Against::seconds ? "CPU seconds" : "rays", plot_file(scene, against));
        text += "\n";
        if (!scene.curves.empty()) text += markdown(curve_rows(scene, true));
        if (!scene.comparisons.empty()) text += markdown(comparison_rows(scene));
        text += about_reference(scene) + ".\n\n";
    }
    return text + methods(record.command);
}

Plot error_plot(const SceneRecord& scene, Against against) {
    Plot plot{fmt::format("{}: error against {}", scene.name, against == Against::seconds ? "run time" : "rays"),
              against == Against::seconds ? "CPU time of rendering [s]" : "rays of all kinds",
              "error",
              {}};
    plot.guides = {{-0.5, "-1/2"}, {-0.75, "-3/4"}, {-1, "-1"}};
    std::vector<std::string> samplers;
    const bool both = !scene.comparisons.empty();
    for (const Curve& curve : scene.curves) {
        auto place = std::ranges::find(samplers, curve.sampler);
        if (place == samplers.end()) place = samplers.insert(samplers.end(), curve.sampler);
        grade::Series series{curve.sampler, {}};
        series.color = int(place - samplers.begin());
        series.dashed = both && curve.who == Who::solution;
        if (series.dashed) series.name += ", right";
        for (const Level& level : curve.levels) {
            const auto [low, high] = level.mse_interval();
            series.points.push_back({against == Against::seconds ? level.seconds() : level.rays(),
                                     level.mse() > 0 ? std::sqrt(level.mse()) : 0, std::sqrt(low), std::sqrt(high)});
        }
        plot.series.push_back(series);
    }
    return plot;
}

std::string plot_file(const SceneRecord& scene, Against against) {
    return fmt::format("{}-{}.svg", scene.name, against == Against::seconds ? "seconds" : "rays");
}

}  // namespace grade::convergence
