#include "report/page_parts.h"

#include <fmt/format.h>

#include "report/plot.h"

namespace grade {

namespace {

std::string in_words(const PictureCost& cost, bool passes) {
    const auto efficiency = passes ? cost.efficiency() : std::nullopt;
    return fmt::format("RMSE {:.3g} in {:.2g} s of CPU time{}", cost.rmse(), cost.cpu_seconds,
                       efficiency ? fmt::format(", efficiency {:.2g}", *efficiency) : "");
}

}  // namespace

std::string cost_line(const CheckRecord& check, bool passes) {
    if (!check.cost || !check.solution_cost) return {};
    return fmt::format("<p class=\"soft\">One picture: {}. The solution: {}.</p>\n", in_words(*check.cost, passes),
                       in_words(*check.solution_cost, passes));
}

std::string error_section(const Record& record) {
    Plot plot{"Pictures of the checks: error against run time", "CPU time of one picture [s]", "RMSE", {}};
    plot.series = {{"solution", {}}, {"submission", {}}};
    for (Series& series : plot.series) series.joined = false;
    for (const FragmentRecord& fragment : record.fragments)
        for (const CheckRecord& check : fragment.checks) {
            if (!check.cost || !check.solution_cost || !check.cost->efficiency() || !check.solution_cost->efficiency())
                continue;
            plot.series[0].points.push_back({check.solution_cost->cpu_seconds, check.solution_cost->rmse()});
            plot.series[1].points.push_back({check.cost->cpu_seconds, check.cost->rmse()});
        }
    if (plot.series[0].points.empty()) return {};
    const auto ratio = record.efficiency_ratio();
    return fmt::format(
        "<h2>Error against run time</h2><section class=\"card\"><div class=\"plot\">{}</div><p class=\"soft\">Each dot "
        "is one picture; what is wrong has a larger error. {}<code>grade converge</code> shows how the error falls "
        "with "
        "time.</p></section>\n",
        log_log(plot),
        ratio ? fmt::format("Efficiency, 1 / (mean squared error x CPU time), is {:.2g} times the solution's in the "
                            "median of fragments that pass. ",
                            *ratio)
              : "");
}

}  // namespace grade
