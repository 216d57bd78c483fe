#pragma once

#include "judging/budget.h"
#include "judging/grading.h"
#include "judging/reference.h"
#include "record/record.h"
#include "statistics/engine.h"

namespace grade {

struct CheckSettings {
    const GradingSettings& grading;
    Settings statistics{};     // alpha is shared by all statistics of the assignment
    Budget* budget = nullptr;  // of the fragment; none: there is no limit but that of each answer
    std::function<std::unique_ptr<Runner>()> another{};  // program of the fragment, for what no verdict hangs on
};

/// Runs a check's experiment, replicate after replicate, until each statistic has its verdict.
CheckRecord run_check(const Check& check, Runner& runner, Reference& reference, const CheckSettings& settings);

/// What is wrong with a check's first observation, and the same again, before any statistic: state that is kept, levels
/// of 8 bits. None: nothing of that kind.
std::optional<Fault> unfit(const Check& check, const Observation& first, const Observation& again,
                           Reference& reference);

/// Whether two seeds give one picture where the solution gives two.
bool ignores_seed(const Check& check, const Observation& first, const Observation& second, Reference& reference);

/// How many statistics have noise, and so share alpha.
int noisy_statistics(const std::vector<Check>& checks);

}  // namespace grade
