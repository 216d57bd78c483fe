#pragma once

#include "diagnosis/relation.h"

namespace grade {

/// The simplest relation of the steps of a fragment's formula (steps.h): a mistake in its middle. None: it has no
/// formula, or no relation explains every call, or every wrong one.
std::optional<Relation> relation_of_steps(const Calls& calls, const Ask& right, bool sampled);

}  // namespace grade
