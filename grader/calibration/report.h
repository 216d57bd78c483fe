#pragma once

#include <string>

#include "calibration/summary.h"
#include "report/plot.h"

namespace grade::calibration {

/// The calibration as Markdown: what was to be shown beside what was measured, then the tables behind it.
///
/// command  that makes this report
/// plot     file name of the picture, to be shown in it
std::string calibration_report(const Summary& summary, const std::string& command, const std::string& plot);

/// How the probability of a wrong verdict falls with the CPU time of a grading.
///
/// fragments  of the assignment
Plot budget_plot(const Summary& summary, int fragments);

}  // namespace grade::calibration
