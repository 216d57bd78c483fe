#pragma once

#include <set>
#include <string>
#include <vector>

#include "assignment/assignment.h"
#include "programs/toolchain.h"

namespace grade {

/// What the words of a command line mean.
struct Chosen {
    std::string submission;           // a folder or an archive
    bool own = false;                 // the starter beside the grader: what its user edits
    std::set<std::string> fragments;  // empty: all
};

/// Names of fragments, and at most one submission; without one, the starter. Throws rt::InputError with the nearest
/// name for a word that is neither.
Chosen choose(const std::vector<std::string>& words, const Toolchain& chain, const Assignment& assignment);

}  // namespace grade
