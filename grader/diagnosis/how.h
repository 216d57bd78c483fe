#pragma once

#include "diagnosis/calls/calls.h"
#include "diagnosis/changes/relation.h"

namespace grade {

/// How wrong answers come about.
struct How {
    std::string words;
    std::string of_numbers{};   // of these, what is said of answers that are numbers
    bool is_elsewhere = false;  // the sample is as good as the solution's, which lies elsewhere
};

How how_of(const Relation& relation);

/// What is wrong with a sample beside its place.
How of_own_numbers(const Calls& all, const Ask& mine, const Ask& right);

/// Which values of a sum, or which of its shares, are wrong.
std::string wrong_sums(const Calls& all, const Ask& mine, const Ask& right);

/// What is wrong where the answer is a number; some answers are not.
How of_numbers(const Calls& calls, const Ask& right, bool sampled);

}  // namespace grade
