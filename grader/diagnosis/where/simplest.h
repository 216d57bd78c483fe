#pragma once

#include "diagnosis/where/where.h"
#include "record/record.h"

namespace grade {

struct Example {
    Row row, mine, right;
    int digits = 6;              // that its arguments are printed with; 0: as many as it takes
    std::vector<bool> told{};    // parts that are printed; empty: all
    std::vector<bool> always{};  // parts that are printed at their defaults too
};

/// The simplest call that goes wrong: from one that does, simpler values are tried as long as they do, and as long as
/// what all calls have in common stays: unit vectors, right angles, which of two is larger, ranges; of the region, if
/// there is one. It is as printed.
Example simplest_wrong(const Calls& calls, const WrongCalls& region, const Ask& mine, const Ask& right);

/// The call with its numbers as they are printed, and the answers to these; with more digits where others would not
/// show the same.
Example as_printed(const Calls& calls, Example example, const Ask& mine, const Ask& right);

/// The call of a finding, in words, and as it can be pasted into a program and into a shell.
void add_call(Finding& finding, const Signature& signature, const Example& example);

}  // namespace grade
