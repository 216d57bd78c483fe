#pragma once

#include <string>

#include "record/record.h"

namespace grade {

/// The record as one page that needs nothing else: no file, no network, no script.
///
/// handout  where the page finds the handout, to which its hints link; empty: nowhere
std::string page(const Record& record, const std::string& handout = "handout.md");

}  // namespace grade
