#pragma once

#include "judging/grading.h"

/// Records of what has not run.
namespace grade {

/// A check as the record has it before it ran.
CheckRecord blank_record(const Check& check);

/// A grading with its fragments, and yet without checks.
Record blank_record(const Programs& programs, const Assignment& assignment, const GradingSettings& settings);

}  // namespace grade
