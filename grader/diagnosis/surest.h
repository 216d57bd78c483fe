#pragma once

#include "diagnosis/changes/relation.h"

namespace grade {

/// Of a relation of the arguments and one of a form's expressions, the simpler one; both, where nothing tells them
/// apart.
std::optional<Relation> simpler(const std::optional<Relation>& of_arguments, const std::optional<Relation>& of_form);

/// The relation that says most: of all calls; else, of rays that start near the shape; of each part of the answer; of
/// two mistakes in every call, or in some and in the others.
std::optional<Relation> surest_relation(const Calls& calls, const Ask& mine, const Ask& right, bool sampled);

/// Whether it says that samples count for nothing, and most of those that are wrong do count: then it is another
/// mistake's.
bool tells_of_few(const Relation& relation, const Calls& all);

}  // namespace grade
