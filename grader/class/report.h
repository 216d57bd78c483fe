#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "class/results.h"

namespace grade::course {

/// Writes what there is of a class: class.json, class.csv, canvas.csv, moodle.csv, index.html, and a page and a record
/// for each submission in submissions/.
///
/// handout  where index.html finds the handout; empty: nowhere
void write_class(const fs::path& out, const std::vector<Result>& results, const std::string& title,
                 const std::string& handout = "");

/// For the terminal: a line for each submission.
std::string class_table(const std::vector<Result>& results);

/// Where the page and the record of a submission are, within OUT, without what their names end in.
std::vector<std::string> places_of(const std::vector<Result>& results);

/// The class page.
///
/// handout  where it finds the handout; empty: nowhere
std::string class_page(const std::vector<Result>& results, const std::string& title, const std::string& handout = "");

}  // namespace grade::course
