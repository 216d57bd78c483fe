#include "report/page_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/plot.h"

namespace grade {

namespace {

/// What no picture shows: rounding alone.
constexpr double least_error = 1e-6;

std::string in_words(const PictureCost& cost) {
    return fmt::format(
        "error {} in {:.2g} s of CPU time",
        cost.rmse() < least_error ? fmt::format("below {:g}", least_error) : fmt::format("{:.3g}", cost.rmse()),
        cost.cpu_seconds);
}

}  // namespace

std::string cost_line(const CheckRecord& check, bool passes) {
    if (!check.cost || !check.solution_cost) return {};
    const auto mine = check.cost->efficiency(), right = check.solution_cost->efficiency();
    return fmt::format("<p class=\"soft\">One picture, yours: {}. The right one: {}.{}</p>\n", in_words(*check.cost),
                       in_words(*check.solution_cost),
                       passes && mine && right && check.cost->rmse() >= least_error
                           ? fmt::format(" Efficiency: {:.2g} times the right one's.", *mine / *right)
                           : "");
}

std::string error_section(const Record& record) {
    Plot plot{
        "Error of pictures against run time", "CPU time of one picture [s]", "error of a pixel (root mean square)", {}};
    plot.least_y = least_error;
    plot.series = {{"the right one", {}}, {"yours", {}}};
    for (Series& series : plot.series) series.joined = false;
    for (const FragmentRecord& fragment : record.fragments) {
        double clearest = 0;
        std::size_t named = 0;  // from 1
        for (const CheckRecord& check : fragment.checks) {
            if (!check.cost || !check.solution_cost || !check.cost->efficiency() || !check.solution_cost->efficiency())
                continue;
            const std::string name = fragment.name + ", " + check.name;
            const auto point = [&](const PictureCost& cost) {
                return Series::Point{cost.cpu_seconds, std::max(cost.rmse(), least_error), 0, 0,
                                     name + ": " + in_words(cost)};
            };
            const Pair pair{point(*check.solution_cost), point(*check.cost), ""};
            plot.series[0].points.push_back(pair.from);
            plot.series[1].points.push_back(pair.to);
            plot.pairs.push_back(pair);
            // of a fragment, where it shows most
            const double ratio = pair.to.y / pair.from.y;
            if (fragment.verdict == Verdict::passed || ratio < std::max(clearest, 1.2)) continue;
            clearest = ratio, named = plot.pairs.size();
        }
        if (named > 0) plot.pairs[named - 1].name = fragment.name;
    }
    if (plot.series[0].points.empty()) return {};
    const auto ratio = record.efficiency_ratio();
    return fmt::format(
        "<h2>Error against run time</h2><section class=\"card\"><details class=\"costs\"><summary>A dot for each "
        "picture: its error, and what it took</summary><div><div class=\"plot\">{}</div>"
        "<p class=\"soft\">Each dot is one picture, joined with the right one of the same check. What is wrong has a "
        "larger error, and its name where there is room; the pointer on a dot shows the others. The foot of the plot "
        "is 1e-6 and less. {}<code>grade converge</code> shows how the error falls with "
        "time.</p></div></details></section>\n",
        log_log(plot),
        ratio ? fmt::format("Efficiency, 1 / (mean squared error × CPU time), is {:.2g} times the right one's in the "
                            "median of fragments that pass. ",
                            *ratio)
              : "");
}

}  // namespace grade
