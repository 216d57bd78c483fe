#pragma once

#include <string>

#include "record/record.h"

/// What pages are put together from.
namespace grade {

/// page.css and page.js, as every page holds them; the build makes them texts.
extern const char* const page_style;
extern const char* const page_script;

/// Deviations that are right; without noise, all that are not wrong.
double right_within(const StatisticRecord& statistic);

/// A statistic as a small drawing: the truth as a line, about it what is right as a band and what is neither right nor
/// wrong as a fainter one, the value as a dot on its confidence interval. Empty where there is no value.
std::string bar(const StatisticRecord& statistic);

/// What one picture of a check costs and how noisy it is, beside the solution's; empty: not known. How efficient that
/// is says nothing where its fragment does not pass.
std::string cost_line(const CheckRecord& check, bool passes);

/// The section with error against run time, a dot for each picture; empty: there is none with noise.
std::string error_section(const Record& record);

}  // namespace grade
