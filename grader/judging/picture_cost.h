#pragma once

#include "judging/reference.h"
#include "record/record.h"

namespace grade {

/// What the pictures of a check cost and how far they are from the truth: the submission's first one and the
/// solution's, each against two pictures of the solution with other seeds.
///
/// first    the submission's first picture
/// seconds  CPU time of its fastest picture
void add_picture_costs(CheckRecord& record, const rt::Image& first, double seconds, Reference& reference);

}  // namespace grade
