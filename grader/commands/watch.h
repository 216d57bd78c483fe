#pragma once

#include <functional>
#include <set>
#include <string>

#include "assignment/assignment.h"
#include "record/record.h"
#include "report/terminal.h"

namespace grade {

/// Grades a folder, shows the result on one screen, and again at each change of a fragment's file, until Ctrl-C.
/// Without a terminal each result follows the last.
///
/// reader  who looks at it
/// only    fragments that are graded; empty: all
/// grade   grades the folder as it is now
/// shown   is called when a result is on the screen
void watch(const std::string& folder, const Reader& reader, const Assignment& assignment,
           const std::set<std::string>& only, const std::function<Record()>& grade,
           const std::function<void(const Record&)>& shown);

}  // namespace grade
