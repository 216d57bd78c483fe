#pragma once

#include <string>

#include "record/record.h"

namespace grade {

/// What one picture of a check costs and how noisy it is, beside the solution's, for the page; empty: not known.
/// How efficient that is says nothing where its fragment does not pass.
std::string cost_line(const CheckRecord& check, bool passes);

/// The page's section with error against run time, a dot for each picture; empty: there is none with noise.
std::string error_section(const Record& record);

}  // namespace grade
