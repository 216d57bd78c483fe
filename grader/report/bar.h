#pragma once

#include <string>

#include "record/record.h"

namespace grade {

/// A statistic as a small drawing: the truth as a line, the tolerance as a band about it, the value as a dot on its
/// confidence interval. Empty where there is no value.
std::string bar(const StatisticRecord& statistic);

}  // namespace grade
