#pragma once

#include <memory>
#include <vector>

#include "judging/reference.h"
#include "record/record.h"

namespace grade {

/// A check, where it stands in the record.
struct Task {
    const Check* check;
    FragmentRecord* fragment;
    CheckRecord* record;
};

/// Checks of one fragment that one program answers, one after the other; another where it has broken down. Which they
/// are does not depend on the number of jobs: a fragment that keeps state gives the same answers on every machine.
struct Lane {
    std::vector<Task> tasks;
    std::unique_ptr<Runner> runner;
};

/// Two for each fragment, so that a single one is graded on two processors.
std::vector<Lane> lanes_of(const std::vector<Task>& tasks);

}  // namespace grade
