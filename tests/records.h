#pragma once

#include "record/record.h"

/// Records to report on.
namespace grade {

inline Record record_with(const std::string& hostile) {
    Record record;
    record.submission = hostile;
    record.title = "Rays";
    record.parts = {{"one", "Part one"}};
    CheckRecord check;
    check.name = "c", check.fragment = "moved", check.verdict = Verdict::failed, check.share = 2,
    check.excerpt = hostile, check.message = hostile;
    StatisticRecord statistic;
    statistic.id = "L3", statistic.what = "width [pixel]", statistic.value = 2.0, statistic.truth = 1.0,
    statistic.low = 1.9, statistic.high = 2.1;
    statistic.tolerance = 0.2, statistic.verdict = Verdict::failed, statistic.hint = hostile;
    check.statistics = {statistic};
    CheckRecord good = check;
    good.verdict = Verdict::passed, good.share = 1, good.message.clear();
    record.fragments = {
        {"moved", "one", 0, 3, "visible", Verdict::failed, hostile, Trouble::none, "", "", {check, good}, 0, true, {}}};
    give_points(record.fragments[0]);
    return record;
}

inline StatisticRecord failing(const std::string& id, const std::string& hint) {
    StatisticRecord statistic;
    statistic.id = id, statistic.hint = hint, statistic.verdict = Verdict::failed;
    return statistic;
}

inline FragmentRecord fragment_with(Verdict verdict, const std::string& message,
                                    std::vector<StatisticRecord> statistics) {
    FragmentRecord fragment;
    CheckRecord check;
    fragment.name = check.fragment = "lens_ray";
    fragment.verdict = check.verdict = verdict;
    check.message = message;
    check.statistics = std::move(statistics);
    fragment.checks = {check};
    return fragment;
}

}  // namespace grade
