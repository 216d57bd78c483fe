#pragma once

#include <string>
#include <vector>

#include "record/record.h"

namespace grade::course {

/// What has changed of a fragment between two records, and why.
struct Change {
    std::string fragment;
    double before = 0, after = 0;
    std::string why;
};

/// Losses first. Fragments that only one of them has are changes from or to 0.
std::vector<Change> changes_between(const Record& before, const Record& after);

/// What two records of the same texts were made with that is not the same, a line each: grader, reference, checks,
/// points, seed.
std::vector<std::string> made_differently(const Record& before, const Record& after);

/// "4 -> 0  hit_sphere: failed, was passed: ...", a line each.
std::string lines_of(const std::vector<Change>& changes);

}  // namespace grade::course
