#pragma once

#include <vector>

#include "class/entries.h"

namespace grade::course {

/// Names and numbers from Gradescope's submission_metadata.yml, where there is one. An entry that it does not name gets
/// a note: its marks could not be matched.
void add_gradescope_names(const fs::path& folder, std::vector<Entry>& entries);

}  // namespace grade::course
