#pragma once

#include <map>
#include <string>

#include "record/record.h"

namespace grade {

/// The record as one page that needs nothing else: no file, no network, no script.
///
/// handout  where the page finds the handout, to which its hints link; empty: nowhere
std::string page(const Record& record, const std::string& handout = "handout.md");

/// Says in the calls that a page shows whose fragments are called, where they are not the starter's.
///
/// submission  as it is typed into a shell
void name_submission_in_calls(Record& record, const std::string& submission);

/// By FRAGMENT/CHECK: its pictures as the page shows them, for CheckRecord::drawn of the same record, read from its
/// file.
std::map<std::string, std::string> picture_parts(const Record& record);

}  // namespace grade
