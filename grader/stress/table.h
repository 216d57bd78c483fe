#pragma once

#include <string>

#include "stress/record.h"

namespace grade {

/// One line for each family: what is swept, the decades that pass, and the solution's.
std::string table(const StressRecord& record, bool color);

}  // namespace grade
