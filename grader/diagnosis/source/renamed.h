#pragma once

#include <vector>

#include "diagnosis/source/edits_in_words.h"

namespace grade {

/// Two names of one statement, each with another one in its place: "a - c" for "c - b", "dot(v, v)" for "dot(u, u)".
/// The simplest ones of each statement.
std::vector<Edit> renamed(const Expressions& all, const std::vector<Mistake>& changes);

/// As a change of the smallest expression that holds both names.
Mistake of_both(const Expressions& all, const Edit& edit);

}  // namespace grade
