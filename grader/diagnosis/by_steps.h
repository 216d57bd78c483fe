#pragma once

#include "diagnosis/relation.h"
#include "diagnosis/where.h"

namespace grade {

/// The simplest relation of the steps of a fragment's formula (steps.h): a mistake in its middle. Where none explains
/// every call, or every wrong one, that which explains most; none: it has no formula, or nothing is explained.
std::optional<Relation> relation_of_steps(const Calls& calls, const Ask& right, bool sampled);

/// Two mistakes, of which one is a change of an argument and the other one a change of a step; in every call.
std::optional<Relation> relation_of_both(const Calls& calls, const Ask& right);

/// What sets wrong calls apart in numbers of the formula, if these tell it exactly; else `otherwise`.
WrongCalls where_wrong_in_steps(const Calls& calls, WrongCalls otherwise);

}  // namespace grade
