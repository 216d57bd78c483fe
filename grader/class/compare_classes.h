#pragma once

#include <string>
#include <vector>

#include "class/results.h"

namespace grade::course {

/// Two gradings of a class.
struct Comparison {
    std::string text;  // a line for each student of whom something is another, and a sum
    bool same = true;  // the same students, points and verdicts
};

Comparison compare_classes(const std::vector<Result>& before, const std::vector<Result>& after);

/// The row of the same student in another list; null: there is none.
const Result* of_student(const std::vector<Result>& list, const Result& result);

}  // namespace grade::course
