#pragma once

#include <string>

#include "stress/record.h"

namespace grade {

/// The record as one page that needs nothing else: what passes, and how the error grows.
std::string page(const StressRecord& record, const std::string& title);

}  // namespace grade
