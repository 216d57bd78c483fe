#pragma once

#include <string>

#include "assignment.h"
#include "report/record.h"

namespace grade {

/// The record as one page that needs nothing else: no file, no network, no script.
std::string page(const Record& record, const Assignment& assignment);

}  // namespace grade
