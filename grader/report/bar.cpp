#include "report/page_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/escape.h"

namespace grade {

namespace {

constexpr double bar_width = 260, bar_height = 34, middle = 15;

}  // namespace

double right_within(const StatisticRecord& statistic) {
    return statistic.exact ? statistic.tolerance : statistic.delta0;
}

std::string bar(const StatisticRecord& statistic) {
    if (!statistic.value || !statistic.truth || !std::isfinite(*statistic.truth)) return {};
    if (std::isnan(*statistic.value)) return "<span class=\"soft\">not to be drawn</span>";
    const double value = *statistic.value, truth = *statistic.truth, low = statistic.low.value_or(value),
                 high = statistic.high.value_or(value);
    const double band = std::max(statistic.tolerance, statistic.delta0), right = right_within(statistic);

    // truth in the middle; a value that is very far off stands at the edge, as an arrow
    double reach = 1.25 * std::max({2 * band, std::abs(value - truth), std::abs(low - truth), std::abs(high - truth)});
    if (band > 0) reach = std::min(reach, 12 * band);
    if (!(reach > 0 && std::isfinite(reach))) reach = 1;
    const auto at = [&](double x) { return bar_width / 2 * (1 + std::clamp((x - truth) / reach, -1.0, 1.0) * 0.96); };
    const bool off = std::abs(value - truth) > reach;
    const char* color = statistic.verdict == Verdict::passed   ? "good"
                        : statistic.verdict == Verdict::failed ? "bad"
                                                               : "open";

    std::string svg = fmt::format(
        "<svg class=\"bar\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" role=\"img\" "
        "aria-label=\"{2}: {3:.4g}, interval "
        "{4:.4g} to {5:.4g}; must be {6:.4g}, right within {7:.3g}, wrong beyond {8:.3g}\">",
        bar_width, bar_height, html(statistic.what), value, low, high, truth, right, band);
    svg +=
        fmt::format("<line class=\"axis\" x1=\"0\" x2=\"{:g}\" y1=\"{:g}\" y2=\"{:g}\"/>", bar_width, middle, middle);
    for (const auto& [kind, half] : {std::pair("between", band), {"band", right}})
        svg += fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"5\" width=\"{:.1f}\" height=\"20\"/>", kind,
                           at(truth - half) - 0.5, at(truth + half) - at(truth - half) + 1);
    svg += fmt::format("<line class=\"truth\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"2\" y2=\"28\"/>", at(truth));
    svg += fmt::format("<line class=\"interval {}\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{}\" y2=\"{}\"/>", color, at(low),
                       at(high), middle, middle);
    if (off) {
        const double tip = at(value), back = tip + (value > truth ? -9 : 9);
        svg += fmt::format("<path class=\"dot {}\" d=\"M{:.1f} {} L{:.1f} {} L{:.1f} {} Z\"/>", color, tip, middle,
                           back, middle - 6, back, middle + 6);
    } else {
        svg += fmt::format("<circle class=\"dot {}\" cx=\"{:.1f}\" cy=\"{}\" r=\"4.5\"/>", color, at(value), middle);
    }
    return svg + "</svg>";
}

}  // namespace grade
