#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "record/record.h"

namespace grade {

/// Its name in the cache.
constexpr const char* last_run_file = "last_run.json";

/// Adds to a record what has changed since the last grading whose results are in this file: a line for each fragment
/// whose verdict or points are others, losses first, and for all beyond some a last one. Then keeps this one's there;
/// fragments that were not graded stay as they were. A file that is none is as good as no last grading.
void compare_with_last(Record& record, const std::filesystem::path& file);

/// What to do next, as a line without its end: about the first fragment of a grading that is wrong, or else a blank,
/// or else the next one in the order of these names that was wrong when it was graded last, or else a blank. Empty:
/// there is none.
///
/// folder  where the fragments' files are, from where one stands: "starter/fragments/"
std::string next_step(const Record& record, const std::vector<std::string>& names, const std::filesystem::path& file,
                      const std::string& folder);

/// The arguments of the simplest call of a fragment that was wrong then; empty: there was none.
std::string last_call(const std::filesystem::path& file, const std::string& fragment);

}  // namespace grade
