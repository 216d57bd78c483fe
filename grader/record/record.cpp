#include "record/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace grade {

namespace {

double rounded(double points) { return std::round(points * 100) / 100; }

}  // namespace

std::string in_numbers(const StatisticRecord& statistic) {
    return fmt::format("{}: {:.4g}; expected {:.4g}", statistic.what, statistic.value.value(), statistic.truth.value());
}

void drop_guesses(FragmentRecord& fragment) {
    if (fragment.finding.how.empty()) return;
    for (CheckRecord& check : fragment.checks)
        for (StatisticRecord& statistic : check.statistics)
            if (statistic.verdict == Verdict::failed && statistic.worth == StatisticRecord::Worth::guess &&
                statistic.value && statistic.truth)
                statistic.hint = in_numbers(statistic);
}

std::optional<double> PictureCost::efficiency() const {
    return mse > 0 && cpu_seconds > 0 ? std::optional(1 / (mse * cpu_seconds)) : std::nullopt;
}

double PictureCost::rmse() const { return std::sqrt(std::max(mse, 0.0)); }

std::optional<double> Record::efficiency_ratio() const {
    std::vector<double> ratios;
    for (const FragmentRecord& fragment : fragments) {
        if (fragment.verdict != Verdict::passed) continue;
        for (const CheckRecord& check : fragment.checks) {
            const auto mine = check.cost ? check.cost->efficiency() : std::nullopt;
            const auto theirs = check.solution_cost ? check.solution_cost->efficiency() : std::nullopt;
            if (mine && theirs) ratios.push_back(*mine / *theirs);
        }
    }
    if (ratios.empty()) return std::nullopt;
    std::ranges::sort(ratios);
    return (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]) / 2;
}

double Record::score() const {
    double sum = 0;
    for (const FragmentRecord& fragment : fragments) sum += fragment.points;
    return rounded(sum);
}

double Record::max_score() const {
    double sum = 0;
    for (const FragmentRecord& fragment : fragments) sum += fragment.max_points;
    return rounded(sum);
}

bool Record::is_complete() const {
    return !fragments.empty() && std::ranges::all_of(fragments, &FragmentRecord::finished);
}

bool is_not_run(const CheckRecord& check) { return check.trouble == Trouble::not_run; }

Verdict worse(Verdict a, Verdict b) {
    constexpr std::array order{Verdict::did_not_build, Verdict::not_started, Verdict::crashed,      Verdict::timed_out,
                               Verdict::not_finite,    Verdict::failed,      Verdict::inconclusive, Verdict::passed};
    return *std::ranges::find_if(order, [&](Verdict verdict) { return verdict == a || verdict == b; });
}

double points_of(const FragmentRecord& fragment) {
    double passed = 0, all = 0;
    for (const CheckRecord& check : fragment.checks) {
        all += check.share;
        if (check.verdict == Verdict::passed) passed += check.share;
    }
    return all > 0 ? rounded(fragment.max_points * passed / all) : 0;
}

void give_points(FragmentRecord& fragment) {
    double all = 0;
    for (const CheckRecord& check : fragment.checks) all += check.share;
    for (CheckRecord& check : fragment.checks) {
        check.max_points = all > 0 ? fragment.max_points * check.share / all : 0;
        check.points = check.verdict == Verdict::passed ? check.max_points : 0;
    }
    fragment.points = points_of(fragment);
}

}  // namespace grade
