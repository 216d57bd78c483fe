#pragma once

#include <string>

#include "assignment/assignment.h"
#include "record/record.h"

namespace grade {

/// The record as one page that needs nothing else: no file, no network, no script.
///
/// handout  where the page finds the handout, to which its hints link
std::string page(const Record& record, const Assignment& assignment, const std::string& handout = "handout.md");

}  // namespace grade
