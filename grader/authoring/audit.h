#pragma once

#include <string>
#include <vector>

#include "assignment/assignment.h"
#include "authoring/source.h"

/// What a fragment lacks to be handed out, as far as texts tell: nothing is compiled or graded.
namespace grade::authoring {

/// What is there, and what is not: "file:line:column: what; what was expected".
struct Audit {
    std::string fragment;
    int checks = 0, statistics = 0;
    int wrong = 0, right = 0, promises = 0;  // variants; promises of tests/variants/promises.py
    std::vector<std::string> scenes;
    std::vector<std::string> lacks;
};

/// In the order of the assignment; fragments: all, if none is named. Throws rt::InputError where a file of the tree
/// cannot be read.
std::vector<Audit> audit(const fs::path& project, const Assignment& assignment,
                         const std::vector<std::string>& fragments);

}  // namespace grade::authoring
